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

#ifndef SAMPLE_SOLIDS_WRITE_CASE_H
#define SAMPLE_SOLIDS_WRITE_CASE_H

#include <Sample_solids/Ground_truth.h>
#include <Sample_solids/field_error.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

namespace Sample_solids {

namespace internal {

inline std::string number(double x, int digits)
{
  char buffer[40];
  std::snprintf(buffer, sizeof(buffer), "%.*g", digits, x);
  return buffer;
}

/// returns a text as JSON writes it between quotation marks.
inline std::string escaped(const std::string& text)
{
  std::string result;
  for (char c : text)
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else
      result += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  return result;
}

inline void append_float(std::string& buffer, double x)
{
  const float value = static_cast<float>(x);
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  for (int k = 0; k < 4; ++k)
    buffer.push_back(static_cast<char>((bits >> (8 * k)) & 255u));
}

inline void write_point(std::ostream& out, const Point& p)
{
  out << '[' << number(p[0], 9) << ", " << number(p[1], 9) << ", " << number(p[2], 9) << ']';
}

inline void write_points(std::ostream& out, const std::vector<Point>& points)
{
  out << '[';
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    out << (i == 0 ? "" : ", ");
    write_point(out, points[i]);
  }
  out << ']';
}

inline void write_curves(std::ostream& out, const std::vector<True_curve>& curves)
{
  out << '[';
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const True_curve& curve = curves[i];
    out << (i == 0 ? "\n" : ",\n") << "  {\"kind\": \"" << name_of(curve.kind)
        << "\", \"closed\": " << (curve.is_closed ? "true" : "false") << ", \"length\": " << number(curve.length, 12)
        << ", \"points\": ";
    write_points(out, curve.points);
    out << '}';
  }
  out << ']';
}

} // namespace internal

/// writes the header of a cloud of so many points, with their distances or without.
inline void write_ply_header(std::ostream& out, double sampling_distance, std::size_t points, bool has_distances = true)
{
  out << "ply\nformat binary_little_endian 1.0\ncomment sampling distance " << internal::number(sampling_distance, 9)
      << "\nelement vertex " << points << "\nproperty float x\nproperty float y\nproperty float z\n"
      << (has_distances ? "property float distance\n" : "") << "end_header\n";
}

/// writes points of a cloud behind its header, and their distances if there are any.
inline bool write_ply_points(std::ostream& out, const Cloud& cloud)
{
  std::string buffer;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    for (double x : cloud.points[i])
      internal::append_float(buffer, x);
    if (!cloud.distances.empty())
      internal::append_float(buffer, cloud.distances[i]);
    if (buffer.size() > (1u << 20) || i + 1 == cloud.points.size())
    {
      out.write(buffer.data(), static_cast<std::streamsize>(buffer.size()));
      buffer.clear();
    }
  }
  return static_cast<bool>(out);
}

/// writes a cloud as binary PLY: floats x, y, z and distance; a comment of the header tells the sampling
/// distance.
inline bool write_ply(std::ostream& out, const Cloud& cloud)
{
  write_ply_header(out, cloud.sampling_distance, cloud.points.size(), !cloud.distances.empty());
  return write_ply_points(out, cloud) && out.flush();
}

/// writes a ground truth as JSON.
inline bool write_truth(std::ostream& out, const Ground_truth& truth, const std::string& name, std::size_t points)
{
  out << "{\"shape\": \"" << internal::escaped(name) << "\", \"r\": " << internal::number(truth.sampling_distance, 12)
      << ", \"points\": " << points << ",\n\"curves\": ";
  internal::write_curves(out, truth.curves);
  out << ",\n\"segments\": ";
  internal::write_curves(out, truth.segments);
  out << ",\n\"corners\": ";
  internal::write_points(out, truth.corners);
  out << "}\n";
  return static_cast<bool>(out.flush());
}

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_WRITE_CASE_H
