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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_GLTF_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_GLTF_H

#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_json.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// The scene of a glTF file: a node per curve, below one that has the place and the unit.
class Gltf_scene
{
public:
  explicit Gltf_scene(const Sampled_wireframe& sampled) : m_sampled(sampled) { find_center(); }

  template <class GeomTraits>
  bool add(const CGAL::Wireframe<GeomTraits>& wireframe, std::string& error)
  {
    std::vector<std::size_t> indices(wireframe.vertices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = i;
    if (!indices.empty())
      add_node("vertices", "", indices, 0, all_curve_types().size());
    for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    {
      const auto& curve = wireframe.curves[i];
      const std::size_t kind = static_cast<std::size_t>(
        std::find(all_curve_types().begin(), all_curve_types().end(), curve.type) - all_curve_types().begin());
      add_node("curve_" + std::to_string(i) + "_" + to_string(curve.type), extras_of(i, curve), m_sampled.polylines[i],
               3, kind);
    }
    if (!m_is_finite)
      error = "the wireframe is too large for the single precision of glTF; scale it down";
    else if (m_bytes.size() > 0xF0000000u)
      error = "there are more points than a glTF file can hold; give a larger sampling_step";
    return error.empty();
  }

  // `uri` is empty if the buffer is in the same file
  std::string json(double meters_per_unit, const std::string& uri) const
  {
    std::string text = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Wireframe_extraction\"},\n\"scene\":0,"
                       "\"scenes\":[{\"name\":\"wireframe\"";
    if (m_nodes.empty())
      return text + "}]}\n";
    Coordinates place = m_center;
    for (double& coordinate : place)
      coordinate *= meters_per_unit;
    const Coordinates scale = {{meters_per_unit, meters_per_unit, meters_per_unit}};
    std::string children;
    for (std::size_t i = 0; i < m_number_of_nodes; ++i)
      children += (i == 0 ? "" : ",") + std::to_string(i + 1);
    text += ",\"nodes\":[0]}],\n\"extensionsUsed\":[\"KHR_materials_unlit\"],\n\"nodes\":[{\"name\":\"wireframe\","
            "\"translation\":"
      + json_array(place, json_number) + ",\"scale\":" + json_array(scale, json_number) + ",\"children\":[" + children
      + "]}" + m_nodes + "],\n\"meshes\":[" + m_meshes + "],\n\"accessors\":[" + m_accessors + "],\n\"materials\":["
      + materials()
      + "],\n"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":"
      + std::to_string(m_bytes.size())
      + ",\"byteStride\":12,\"target\":34962}],\n\"buffers\":[{\"byteLength\":" + std::to_string(m_bytes.size());
    if (!uri.empty())
      text += ",\"uri\":\"" + uri + "\"";
    return text + "}]}\n";
  }

  const std::string& bytes() const { return m_bytes; }

private:
  // Single precision is enough around the middle, but not at coordinates that are far off.
  void find_center()
  {
    if (m_sampled.points.empty())
      return;
    Coordinates low = m_sampled.points.front(), high = low;
    for (const Coordinates& point : m_sampled.points)
      for (std::size_t i = 0; i < 3; ++i)
      {
        low[i] = (std::min)(low[i], point[i]);
        high[i] = (std::max)(high[i], point[i]);
      }
    for (std::size_t i = 0; i < 3; ++i)
      m_center[i] = 0.5 * low[i] + 0.5 * high[i];
  }

  template <class GeomTraits>
  static std::string extras_of(std::size_t index, const Wireframe_curve<GeomTraits>& curve)
  {
    return ",\"extras\":{\"index\":" + std::to_string(index) + ",\"type\":\"" + to_string(curve.type) + "\",\"closed\":"
      + (curve.is_closed() ? "true" : "false") + ",\"rms\":" + json_number(CGAL::to_double(curve.rms))
      + ",\"max\":" + json_number(CGAL::to_double(curve.max)) + ",\"support\":" + std::to_string(curve.support) + "}";
  }

  // with a mesh of its own; the mode is that of glTF: 0 for points, 3 for a polyline
  void add_node(const std::string& name, const std::string& extras, const std::vector<std::size_t>& indices, int mode,
                std::size_t material)
  {
    const std::string number = std::to_string(m_number_of_nodes), separator = (m_number_of_nodes == 0 ? "\n" : ",\n");
    add_accessor(indices, separator);
    m_meshes += separator + "{\"primitives\":[{\"attributes\":{\"POSITION\":" + number
      + "},\"mode\":" + std::to_string(mode) + ",\"material\":" + std::to_string(material) + "}]}";
    m_nodes += ",\n{\"name\":\"" + name + "\",\"mesh\":" + number + extras + "}";
    ++m_number_of_nodes;
  }

  void add_accessor(const std::vector<std::size_t>& indices, const std::string& separator)
  {
    const std::size_t offset = m_bytes.size();
    std::array<float, 3> low, high;
    for (std::size_t i = 0; i < indices.size(); ++i)
      for (std::size_t j = 0; j < 3; ++j)
      {
        const float coordinate = to_float(m_sampled.points[indices[i]][j] - m_center[j]);
        low[j] = (i == 0) ? coordinate : (std::min)(low[j], coordinate);
        high[j] = (i == 0) ? coordinate : (std::max)(high[j], coordinate);
        append_little_endian(coordinate, m_bytes);
      }
    const auto to_text = [](float value) { return json_number(static_cast<double>(value)); };
    m_accessors += separator + "{\"bufferView\":0,\"byteOffset\":" + std::to_string(offset)
      + ",\"componentType\":5126,\"count\":" + std::to_string(indices.size())
      + ",\"type\":\"VEC3\",\"min\":" + json_array(low, to_text) + ",\"max\":" + json_array(high, to_text) + "}";
  }

  // a conversion of what is out of range is undefined
  float to_float(double value)
  {
    if (std::abs(value) < 3.4e38)
      return static_cast<float>(value);
    m_is_finite = false;
    return 0.f;
  }

  // one per kind of curve, and one for the vertices
  static std::string materials()
  {
    std::string text;
    for (const Wireframe_curve_type type : all_curve_types())
      text += material(to_string(type), colour_of(type)) + ",";
    return text + material("vertex", {0, 0, 0});
  }

  // colours are linear in glTF, and not those of a screen
  static std::string material(const std::string& name, const Colour& colour)
  {
    const auto linear = [](int value) { return json_number(std::round(1e4 * std::pow(value / 255., 2.2)) * 1e-4); };
    const std::array<int, 3> channels = {{colour.red, colour.green, colour.blue}};
    std::string factor = json_array(channels, linear);
    factor.insert(factor.size() - 1, ",1");
    return "\n{\"name\":\"" + name + "\",\"pbrMetallicRoughness\":{\"baseColorFactor\":" + factor
      + ",\"metallicFactor\":0},\"extensions\":{\"KHR_materials_unlit\":{}}}";
  }

  const Sampled_wireframe& m_sampled;
  Coordinates m_center = {{0., 0., 0.}};
  std::string m_nodes, m_meshes, m_accessors, m_bytes;
  std::size_t m_number_of_nodes = 0;
  bool m_is_finite = true;
};

// the header of a .glb file, and its two chunks, which are filled up to multiples of four bytes
inline void write_glb(std::ostream& out, std::string json, const std::string& bytes)
{
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string start = "glTF", middle;
  append_little_endian(std::uint32_t(2), start);
  const std::size_t size = 20 + json.size() + (bytes.empty() ? 0 : 8 + bytes.size());
  append_little_endian(static_cast<std::uint32_t>(size), start);
  append_little_endian(static_cast<std::uint32_t>(json.size()), start);
  start += "JSON";
  if (!bytes.empty()) // which are coordinates of four bytes each
  {
    append_little_endian(static_cast<std::uint32_t>(bytes.size()), middle);
    middle += std::string("BIN\0", 4);
  }
  out << start << json << middle << bytes;
}

template <class GeomTraits, class NamedParameters>
bool write_gltf(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, bool is_binary,
                const NamedParameters& np, std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, np, sampled, error))
    return false;
  Gltf_scene scene(sampled);
  if (!scene.add(wireframe, error))
    return false;
  const double meters = meters_of(get_length_unit(np));
  if (is_binary)
    write_glb(out, scene.json(meters, ""), scene.bytes());
  else
    out << scene.json(meters, "data:application/octet-stream;base64," + to_base64(scene.bytes()));
  return true;
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the format glTF 2.0.
///
/// Every curve is a polyline (`LINE_STRIP`) with a node of its own, which is named after the index and the
/// type of the curve, such as `curve_0_line`, and has `extras` with `index`, `type`, `closed`, `rms`, `max`
/// and `support`; a closed polyline ends with the point it starts with. A node named `vertices` has the
/// vertices as `POINTS`. Each kind of curve has a colour.
///
/// Coordinates are in single precision, relative to the middle of the wireframe: the node `wireframe`, above
/// all others, has the middle as its translation, so that wireframes keep their precision far off the origin,
/// too. The unit of glTF is the meter, so this node also has a scale, which converts from `unit`. Axes are
/// not turned: glTF takes `y` as up.
///
/// The format does not hold the curves themselves, their parameters and uncertainties, which vertices they
/// join, and the sampling distance.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{sampling_step}
///     \cgalParamDescription{the largest arc length between two neighbouring points of a curve}
///     \cgalParamType{`GeomTraits::FT`}
///     \cgalParamDefault{0.25 times the sampling distance of the wireframe; one hundredth of the longest
///                       curve if that is 0}
///     \cgalParamExtra{in the unit of the wireframe; has to be positive. A curve is split evenly into as few
///                     pieces as that allows, a closed one into three at least.}
///   \cgalParamNEnd
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; the node `wireframe` scales it to meters}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{use_binary_mode}
///     \cgalParamDescription{whether the binary form of the format (`.glb`) is written, or JSON (`.gltf`)
///                           with the coordinates in base64; a stream for the binary form has to be opened in
///                           binary mode}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the stream cannot be written.
///
/// Takes time and memory linear in the number of points.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_gltf(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(stream, np, [&](std::ostream& out, std::string& error) {
    namespace internal_np = CGAL::Wireframe_extraction::internal_np;
    const bool is_binary =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::use_binary_mode), false);
    return internal::write_gltf(out, wireframe, is_binary, np, error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the format glTF 2.0.
///
/// The content is that of the overload for a stream.
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
/// A file with the extension `.glb` (in upper or lower case) has the binary form, any other is JSON with the
/// coordinates in base64.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{sampling_step}
///     \cgalParamDescription{the largest arc length between two neighbouring points of a curve}
///     \cgalParamType{`GeomTraits::FT`}
///     \cgalParamDefault{0.25 times the sampling distance of the wireframe; one hundredth of the longest
///                       curve if that is 0}
///     \cgalParamExtra{in the unit of the wireframe; has to be positive. A curve is split evenly into as few
///                     pieces as that allows, a closed one into three at least.}
///   \cgalParamNEnd
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; the node `wireframe` scales it to meters}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the file cannot be written.
///
/// Takes time and memory linear in the number of points.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_gltf(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_gltf(out, wireframe, internal::lower_extension(filename) == ".glb", np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_GLTF_H
