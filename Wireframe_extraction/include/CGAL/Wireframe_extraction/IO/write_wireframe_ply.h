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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_PLY_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_PLY_H

#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

inline void write_ply_header(std::ostream& out, const Sampled_wireframe& sampled, std::size_t number_of_edges,
                             bool is_binary)
{
  out << "ply\nformat " << (is_binary ? "binary_little_endian" : "ascii") << " 1.0\ncomment wireframe\n"
      << "element vertex " << std::to_string(sampled.points.size())
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element edge " << std::to_string(number_of_edges)
      << "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\nend_header\n";
}

inline void write_ply_point(std::ostream& out, const Coordinates& point, bool is_binary)
{
  std::string text;
  if (is_binary)
    for (const double coordinate : point)
      append_little_endian(coordinate, text);
  else
    text = to_text(point) + "\n";
  out << text;
}

inline void write_ply_edge(std::ostream& out, std::size_t first, std::size_t second, std::size_t curve, bool is_binary)
{
  std::string text;
  if (is_binary)
    for (const std::size_t index : {first, second, curve})
      append_little_endian(static_cast<std::uint32_t>(index), text);
  else
    text = std::to_string(first) + " " + std::to_string(second) + " " + std::to_string(curve) + "\n";
  out << text;
}

template <class GeomTraits, class NamedParameters>
bool write_ply(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
               std::string& error)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  const bool is_binary =
    CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::use_binary_mode), true);
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, np, sampled, error))
    return false;
  if (sampled.points.size() > static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)()))
  {
    error = "there are more points than a PLY file can number; give a larger sampling_step";
    return false;
  }
  std::size_t number_of_edges = 0;
  for (const std::vector<std::size_t>& polyline : sampled.polylines)
    number_of_edges += polyline.size() - 1;
  write_ply_header(out, sampled, number_of_edges, is_binary);
  for (const Coordinates& point : sampled.points)
    write_ply_point(out, point, is_binary);
  for (std::size_t i = 0; i < sampled.polylines.size(); ++i)
    for (std::size_t j = 0; j + 1 < sampled.polylines[i].size(); ++j)
      write_ply_edge(out, sampled.polylines[i][j], sampled.polylines[i][j + 1], i, is_binary);
  return true;
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the PLY format.
///
/// The element `vertex` (`double` properties `x`, `y`, `z`) starts with the vertices of the wireframe in
/// their order and goes on with the points on its curves; the element `edge` (`int` properties `vertex1`,
/// `vertex2`, `curve`) holds the pieces of the curves and the index of the curve to which each belongs.
/// Curves that share a vertex share its point. A stream for the binary mode has to be opened in binary mode.
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
///   \cgalParamNBegin{use_binary_mode}
///     \cgalParamDescription{whether the file is binary (little endian) or ascii; ascii has all digits, too}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
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
bool write_wireframe_ply(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(
    stream, np, [&](std::ostream& out, std::string& error) { return internal::write_ply(out, wireframe, np, error); });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the PLY format.
///
/// The content is that of the overload for a stream.
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
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
///   \cgalParamNBegin{use_binary_mode}
///     \cgalParamDescription{whether the file is binary (little endian) or ascii; ascii has all digits, too}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
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
bool write_wireframe_ply(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_ply(out, wireframe, np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_PLY_H
