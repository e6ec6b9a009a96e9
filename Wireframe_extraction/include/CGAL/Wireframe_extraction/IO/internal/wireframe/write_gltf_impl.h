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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_GLTF_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_GLTF_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/json_text.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_gltf.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/policies.h>

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

  bool add(const Plain_wireframe& wireframe, std::string& error)
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

  static std::string extras_of(std::size_t index, const Plain_curve& curve)
  {
    return ",\"extras\":{\"index\":" + std::to_string(index) + ",\"type\":\"" + to_string(curve.type)
      + "\",\"closed\":" + (curve.is_closed() ? "true" : "false") + ",\"rms\":" + json_number(curve.rms)
      + ",\"max\":" + json_number(curve.max) + ",\"support\":" + std::to_string(curve.support) + "}";
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

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_gltf(std::ostream& out, const Plain_wireframe& wireframe, const Curve_sampling& sampling,
                Wireframe_extraction::Length_unit unit, bool is_binary, std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, sampling, sampled, error))
    return false;
  Gltf_scene scene(sampled);
  if (!scene.add(wireframe, error))
    return false;
  const double meters = meters_of(unit);
  if (is_binary)
    write_glb(out, scene.json(meters, ""), scene.bytes());
  else
    out << scene.json(meters, "data:application/octet-stream;base64," + to_base64(scene.bytes()));
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_GLTF_IMPL_H
