// Copyright (c) 2026 The Wireframe_extraction authors.
// All rights reserved.
//
// This file is part of Wireframe_extraction, a package in the conventions of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Wireframe_extraction authors

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DXF_FRAME_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DXF_FRAME_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace IO {
namespace internal {

// What a DXF file of AutoCAD 2000 (AC1015) must have around its entities: tables, blocks, and a dictionary of objects.
// Handles are hexadecimal numbers without meaning; those below 100 are used here, entities have the others.

struct Dxf_layer
{
  const char* name;
  int colour; // in the numbering of AutoCAD
};

inline Dxf_layer dxf_layer_of(Wireframe_curve_type type)
{
  const char* const name = layer_of(type);
  switch (type)
  {
  case Wireframe_curve_type::LINE: return {name, 7};
  case Wireframe_curve_type::CIRCLE: return {name, 1};
  case Wireframe_curve_type::ARC: return {name, 30};
  case Wireframe_curve_type::ELLIPSE: return {name, 5};
  case Wireframe_curve_type::ELLIPTIC_ARC: return {name, 4};
  default: return {name, 6};
  }
}

inline Dxf_layer dxf_layer_of_vertices() { return {"VERTICES", 3}; }

inline std::string to_hexadecimal(std::size_t number)
{
  std::string digits;
  for (; number > 0 || digits.empty(); number /= 16)
    digits.insert(digits.begin(), "0123456789ABCDEF"[number % 16]);
  return digits;
}

// DXF is a list of pairs of a group code and a value, each on a line of its own.
class Dxf_text
{
public:
  void add(int code, const std::string& value) { m_text += std::to_string(code) + "\n" + value + "\n"; }

  void add(int code, double value)
  {
    m_is_finite = m_is_finite && std::isfinite(value);
    add(code, number_to_string(value));
  }

  void add(int code, int value) { add(code, std::to_string(value)); }
  void add(int code, std::size_t value) { add(code, std::to_string(value)); }

  // a point or vector; its coordinates have codes that are 10 apart
  void add(int code, const Spline_vector& v)
  {
    add(code, v.x);
    add(code + 10, v.y);
    add(code + 20, v.z);
  }

  // several pairs: code, blank, and value, separated by line feeds
  void add(const char* pairs)
  {
    for (std::string_view rest(pairs); !rest.empty();)
    {
      const std::size_t end = (std::min)(rest.find('\n'), rest.size()), blank = rest.find(' ');
      m_text += std::string(rest.substr(0, blank)) + "\n" + std::string(rest.substr(blank + 1, end - blank - 1)) + "\n";
      rest.remove_prefix((std::min)(end + 1, rest.size()));
    }
  }

  void add_table(const std::string& name, const std::string& handle, int count)
  {
    add(0, "TABLE");
    add(2, name);
    add(5, handle);
    add("330 0\n100 AcDbSymbolTable");
    add(70, count);
  }

  const std::string& text() const { return m_text; }
  bool is_finite() const { return m_is_finite; }

private:
  std::string m_text;
  bool m_is_finite = true;
};

// the box around the content, which may be empty
struct Dxf_extent
{
  Spline_vector low, high;
  bool is_empty = true;

  void add(const Spline_vector& p)
  {
    low = is_empty ? p : Spline_vector{(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
    high = is_empty ? p : Spline_vector{(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
    is_empty = false;
  }
};

inline int dxf_unit(CGAL::Wireframe_extraction::Length_unit unit)
{
  typedef CGAL::Wireframe_extraction::Length_unit Length_unit;
  switch (unit)
  {
  case Length_unit::INCH: return 1;
  case Length_unit::FOOT: return 2;
  case Length_unit::CENTIMETER: return 5;
  case Length_unit::METER: return 6;
  case Length_unit::MICROMETER: return 13;
  default: return 4;
  }
}

inline void add_dxf_header(CGAL::Wireframe_extraction::Length_unit unit, const Dxf_extent& extent,
                           const std::string& next_handle, Dxf_text& dxf)
{
  const int code = dxf_unit(unit);
  dxf.add("0 SECTION\n2 HEADER\n9 $ACADVER\n1 AC1015\n9 $DWGCODEPAGE\n3 ANSI_1252\n9 $INSUNITS");
  dxf.add(70, code);
  dxf.add("9 $MEASUREMENT");
  dxf.add(70, code <= 2 ? 0 : 1);
  dxf.add("9 $EXTMIN");
  dxf.add(10, extent.low);
  dxf.add("9 $EXTMAX");
  dxf.add(10, extent.high);
  dxf.add("9 $HANDSEED");
  dxf.add(5, next_handle);
  dxf.add("0 ENDSEC\n0 SECTION\n2 CLASSES\n0 ENDSEC");
}

// an isometric view of the whole content
inline void add_dxf_view(const Dxf_extent& extent, Dxf_text& dxf)
{
  const double size = norm(0.5 * extent.high - 0.5 * extent.low) * 2.;
  dxf.add_table("VPORT", "8", 1);
  dxf.add("0 VPORT\n5 30\n330 8\n100 AcDbSymbolTableRecord\n100 AcDbViewportTableRecord\n2 *Active\n70 0\n"
          "10 0\n20 0\n11 1\n21 1\n12 0\n22 0\n13 0\n23 0\n14 10\n24 10\n15 10\n25 10\n16 1\n26 -1\n36 1");
  dxf.add(17, 0.5 * extent.low + 0.5 * extent.high);
  dxf.add(40, size > 0. ? size : 1.);
  dxf.add("41 1.5\n42 50\n43 0\n44 0\n50 0\n51 0\n71 0\n72 100\n73 1\n74 3\n75 0\n76 0\n77 0\n78 0\n0 ENDTAB");
}

inline void add_dxf_layer(const Dxf_layer& layer, std::size_t handle, Dxf_text& dxf)
{
  dxf.add(0, "LAYER");
  dxf.add(5, to_hexadecimal(handle));
  dxf.add("330 2\n100 AcDbSymbolTableRecord\n100 AcDbLayerTableRecord");
  dxf.add(2, layer.name);
  dxf.add(70, 0);
  dxf.add(62, layer.colour);
  dxf.add("6 Continuous\n370 -3\n390 F");
}

inline void add_dxf_layers(Dxf_text& dxf)
{
  std::size_t handle = 0x40;
  dxf.add_table("LAYER", "2", static_cast<int>(all_curve_types().size()) + 2);
  add_dxf_layer({"0", 7}, handle++, dxf);
  for (const Wireframe_curve_type type : all_curve_types())
    add_dxf_layer(dxf_layer_of(type), handle++, dxf);
  add_dxf_layer(dxf_layer_of_vertices(), handle++, dxf);
  dxf.add("0 ENDTAB");
}

inline void add_dxf_line_types(Dxf_text& dxf)
{
  std::size_t handle = 0x31;
  dxf.add_table("LTYPE", "5", 3);
  for (const char* const name : {"ByBlock", "ByLayer", "Continuous"})
  {
    dxf.add(0, "LTYPE");
    dxf.add(5, to_hexadecimal(handle++));
    dxf.add("330 5\n100 AcDbSymbolTableRecord\n100 AcDbLinetypeTableRecord");
    dxf.add(2, name);
    dxf.add("70 0\n3 \n72 65\n73 0\n40 0");
  }
  dxf.add("0 ENDTAB");
}

inline void add_dxf_tables(const Dxf_extent& extent, Dxf_text& dxf)
{
  dxf.add("0 SECTION\n2 TABLES");
  add_dxf_view(extent, dxf);
  add_dxf_line_types(dxf);
  add_dxf_layers(dxf);
  dxf.add_table("STYLE", "3", 1);
  dxf.add("0 STYLE\n5 35\n330 3\n100 AcDbSymbolTableRecord\n100 AcDbTextStyleTableRecord\n2 Standard\n70 0\n40 0\n"
          "41 1\n50 0\n71 0\n42 2.5\n3 txt\n4 \n0 ENDTAB");
  dxf.add_table("VIEW", "6", 0);
  dxf.add("0 ENDTAB");
  dxf.add_table("UCS", "7", 0);
  dxf.add("0 ENDTAB");
  dxf.add_table("APPID", "9", 1);
  dxf.add("0 APPID\n5 36\n330 9\n100 AcDbSymbolTableRecord\n100 AcDbRegAppTableRecord\n2 ACAD\n70 0\n0 ENDTAB");
  dxf.add_table("DIMSTYLE", "A", 1);
  dxf.add("100 AcDbDimStyleTable\n71 1\n340 37\n0 DIMSTYLE\n105 37\n330 A\n100 AcDbSymbolTableRecord\n"
          "100 AcDbDimStyleTableRecord\n2 Standard\n70 0\n0 ENDTAB");
  dxf.add_table("BLOCK_RECORD", "1", 2);
  dxf.add("0 BLOCK_RECORD\n5 1F\n330 1\n100 AcDbSymbolTableRecord\n100 AcDbBlockTableRecord\n2 *Model_Space\n340 22\n"
          "0 BLOCK_RECORD\n5 1B\n330 1\n100 AcDbSymbolTableRecord\n100 AcDbBlockTableRecord\n2 *Paper_Space\n340 1E\n"
          "0 ENDTAB\n0 ENDSEC");
}

inline void add_dxf_blocks(Dxf_text& dxf)
{
  dxf.add("0 SECTION\n2 BLOCKS\n"
          "0 BLOCK\n5 20\n330 1F\n100 AcDbEntity\n8 0\n100 AcDbBlockBegin\n2 *Model_Space\n70 0\n10 0\n20 0\n30 0\n"
          "3 *Model_Space\n1 \n0 ENDBLK\n5 21\n330 1F\n100 AcDbEntity\n8 0\n100 AcDbBlockEnd\n"
          "0 BLOCK\n5 1C\n330 1B\n100 AcDbEntity\n67 1\n8 0\n100 AcDbBlockBegin\n2 *Paper_Space\n70 0\n10 0\n20 0\n"
          "30 0\n3 *Paper_Space\n1 \n0 ENDBLK\n5 1D\n330 1B\n100 AcDbEntity\n67 1\n8 0\n100 AcDbBlockEnd\n0 ENDSEC");
}

inline void add_dxf_layout(const char* name, const char* handle, const char* block_record, int order, Dxf_text& dxf)
{
  dxf.add(0, "LAYOUT");
  dxf.add(5, handle);
  dxf.add("330 1A\n100 AcDbPlotSettings\n1 \n2 none_device\n4 \n6 \n40 0\n41 0\n42 0\n43 0\n44 0\n45 0\n46 0\n47 0\n"
          "48 0\n49 0\n140 0\n141 0\n142 1\n143 1");
  dxf.add(70, order == 0 ? 1712 : 688);
  dxf.add("72 0\n73 0\n74 5\n7 \n75 16\n147 1\n148 0\n149 0\n100 AcDbLayout");
  dxf.add(1, name);
  dxf.add(70, 1);
  dxf.add(71, order);
  dxf.add("10 0\n20 0\n11 420\n21 297\n12 0\n22 0\n32 0\n14 1e20\n24 1e20\n34 1e20\n15 -1e20\n25 -1e20\n35 -1e20\n"
          "146 0\n13 0\n23 0\n33 0\n16 1\n26 0\n36 0\n17 0\n27 1\n37 0\n76 0");
  dxf.add(330, block_record);
}

inline void add_dxf_objects(Dxf_text& dxf)
{
  dxf.add("0 SECTION\n2 OBJECTS\n"
          "0 DICTIONARY\n5 C\n330 0\n100 AcDbDictionary\n281 1\n3 ACAD_GROUP\n350 D\n3 ACAD_LAYOUT\n350 1A\n"
          "3 ACAD_PLOTSTYLENAME\n350 E\n"
          "0 DICTIONARY\n5 D\n330 C\n100 AcDbDictionary\n281 1\n"
          "0 ACDBDICTIONARYWDFLT\n5 E\n330 C\n100 AcDbDictionary\n281 1\n3 Normal\n350 F\n"
          "100 AcDbDictionaryWithDefault\n340 F\n0 ACDBPLACEHOLDER\n5 F\n330 E\n"
          "0 DICTIONARY\n5 1A\n330 C\n100 AcDbDictionary\n281 1\n3 Layout1\n350 1E\n3 Model\n350 22");
  add_dxf_layout("Layout1", "1E", "1B", 1, dxf);
  add_dxf_layout("Model", "22", "1F", 0, dxf);
  dxf.add("0 ENDSEC\n0 EOF");
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DXF_FRAME_H
