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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_READ_DISTANCE_CLOUD_H
#define CGAL_WIREFRAME_EXTRACTION_IO_READ_DISTANCE_CLOUD_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/available_cloud_libraries.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/cloud_formats.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/value_type_traits.h>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <iterator>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

#ifndef DOXYGEN_RUNNING
template <class Point, class Vector>
class Point_set_3;
#endif

namespace IO {
namespace internal {

// puts samples at the end of a vector of pairs
template <class Point, class FT>
class Cloud_sink : public Sample_sink
{
public:
  explicit Cloud_sink(std::vector<std::pair<Point, FT>>& cloud) : m_cloud(cloud) {}

  void reserve(std::size_t count) override { m_cloud.reserve(count); }

  bool operator()(const Distance_sample* first, const Distance_sample* last) override
  {
    for (; first != last; ++first)
      m_cloud.emplace_back(Point(first->x, first->y, first->z), FT(first->distance));
    return true;
  }

private:
  std::vector<std::pair<Point, FT>>& m_cloud;
};

template <class FT>
double largest_magnitude_of()
{
  if constexpr (std::is_floating_point<FT>::value && sizeof(FT) < sizeof(double))
    return static_cast<double>((std::numeric_limits<FT>::max)());
  else
    return (std::numeric_limits<double>::max)();
}

// what the named parameters say about reading
template <class FT, class NamedParameters>
Cloud_reader_options get_cloud_reader_options(const NamedParameters& np)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;

  Cloud_reader_options options;
  options.format = choose_parameter(get_parameter_reference(np, internal_np::input_format), std::string());
  options.coordinate_properties =
    choose_parameter(get_parameter_reference(np, internal_np::coordinate_properties), std::vector<std::string>());
  options.distance_property =
    choose_parameter(get_parameter_reference(np, internal_np::distance_property), std::string());
  options.points_dataset = choose_parameter(get_parameter_reference(np, internal_np::points_dataset), std::string());
  options.distances_dataset =
    choose_parameter(get_parameter_reference(np, internal_np::distances_dataset), std::string());
  options.clamp_negative = choose_parameter(get_parameter(np, internal_np::clamp_negative), false);
  options.skip_invalid = choose_parameter(get_parameter(np, internal_np::skip_invalid), false);
  options.largest_magnitude = largest_magnitude_of<FT>();
  return options;
}

// runs `read()`, which returns what went wrong, and adds that memory may be short
template <class Read>
std::string read_in_memory(const std::string& filename, const Read& read)
{
  try
  {
    return read();
  }
  catch (const std::bad_alloc&)
  {
    return filename + ": there is not enough memory for its points";
  }
  catch (const std::length_error&)
  {
    return filename + ": there is not enough memory for its points";
  }
}

// Reads samples into a vector by `read(options, sink, number_of_skipped)`, which returns what went wrong, and tells
// whoever wants to know how it went.
template <class Point, class FT, class NamedParameters, class Read>
bool read_distance_cloud_by(const Read& read, const std::string& name, std::vector<std::pair<Point, FT>>& cloud,
                            const NamedParameters& np)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  Cloud_reader_options options = get_cloud_reader_options<FT>(np);
  std::size_t number_of_skipped = 0;
  std::vector<std::pair<Point, FT>> result;
  Cloud_sink<Point, FT> sink(result);
  const std::string error = read_in_memory(name, [&] { return read(options, sink, number_of_skipped); });
  if (error.empty())
    cloud.swap(result);

  std::size_t* const skipped =
    choose_parameter(get_parameter(np, internal_np::number_of_skipped), static_cast<std::size_t*>(nullptr));
  if (skipped != nullptr)
    *skipped = (error.empty() ? number_of_skipped : 0);
  return report(np, error);
}

// `distances_filename` may be null
template <class Point, class FT, class NamedParameters>
bool read_distance_cloud_of_files(const std::string& filename, const std::string* distances_filename,
                                  std::vector<std::pair<Point, FT>>& cloud, const NamedParameters& np)
{
  Separate_distances distances;
  const Cloud_libraries libraries = available_cloud_libraries();
  const auto read = [&](Cloud_reader_options& options, Sample_sink& sink, std::size_t& number_of_skipped) {
    if (distances_filename != nullptr)
    {
      const std::string distances_error = read_distances_file(*distances_filename, options, libraries, distances);
      if (!distances_error.empty())
        return distances_error;
      options.distances = &distances;
    }
    return read_cloud(filename, options, libraries, sink, number_of_skipped);
  };
  return read_distance_cloud_by(read, filename, cloud, np);
}

// whether the type is that of an iterator
template <class T, class = void>
struct Is_iterator : std::false_type
{};
template <class T>
struct Is_iterator<T, std::void_t<typename std::iterator_traits<T>::iterator_category>> : std::true_type
{};

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// reads a point cloud with a distance per point from one file.
///
/// The extension of the file, in upper or lower case, decides on the format:
/// - `.ply`: ascii or binary of either byte order. The element `vertex` needs the properties `x`, `y`, `z`
///   and one for the distance, each a floating point number or integer of any size, in any order. Other
///   properties and other elements are passed over.
/// - `.xyz`, `.txt`, `.csv`, `.asc`, `.pts`: text with one point per line, whose columns are separated by
///   blanks, commas, or semicolons, and may be quoted. The distance is in the fourth column, unless a line of names
///   before the first point (which may be a comment) says otherwise: then it has to name `x`, `y` and `z`, or as
///   ParaView does `Points:0`, `Points:1` and `Points:2`. Where there are no names, further columns may follow; if, as
///   far as several rows tell, columns four to six look like a normal or a color, the number of the column with the
///   distance, counted from 1, must be given as `distance_property`. Comments start with `#`, `//` or `%`, or behind
///   numbers with `#`; a line such as `sep=;` says what separates the columns; a first line that holds only the number
///   of points is checked against it. Every line must have as many columns as the first.
/// - `.pcd`: ascii, binary, or compressed, with the fields `x`, `y`, `z` and one for the distance.
/// - `.npy`: an array of floating point numbers (also of half precision) or integers with four columns, the last of
///   which is the distance; or a structured one, with the fields `x`, `y`, `z` and one for the distance.
/// - `.npz`: the arrays `points` (N x 3) and `distances` (N); or one that has the distances in it, as a `.npy` file
///   does. An array of points may have any name if there is no other one. What `numpy.savez_compressed()` writes needs
///   zlib.
/// - `.h5`, `.hdf5`: the same as data sets, with HDF5. Other data sets are not looked at.
/// - `.off`, also with colours and normals: the vertices of a mesh. They have no distances: use the other overload.
///
/// Clouds without distances are read by `CGAL::IO::read_points()`, and, chunk by chunk and in all of these formats, by
/// `IO::Distance_cloud_file`.
///
/// HDF5 files may hold patches, as files of the regressor DEF do: points B x N x 3, and distances B x N; or B
/// rows of different lengths, of points (each 3 N numbers) and of distances. All patches are put one after the other,
/// and where they overlap, points are there more than once: `read_distance_patches()` and
/// `Wireframe_extraction::fuse_distance_patches()` merge them. So may the arrays of `.npy` and `.npz`.
///
/// HDF5 is there if the macro `CGAL_WIREFRAME_EXTRACTION_USE_HDF5` is defined, as the CMake target
/// `CGAL::Wireframe_extraction_HDF5` does, and zlib with `CGAL_WIREFRAME_EXTRACTION_USE_ZLIB` and
/// `CGAL::Wireframe_extraction_ZLIB`. The HDF5 library is only as safe in several threads as it was built to be, and
/// its older versions (1.10 is one) can crash on files that were damaged on purpose; truncated ones are refused. What
/// comes from strangers is better read as `.npz`.
///
/// Decimals are written with a point whatever the locale. Coordinates and distances have to be finite and the
/// distances not negative, else the file is refused, or the points left out with `skip_invalid`.
///
/// \tparam Point a type constructible from three `double` coordinates
/// \tparam FT a model of `FieldNumberType` that is constructible from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param cloud the points and their distances, in the order of the file. What it held before is replaced;
///   it is left as it was if reading fails.
/// \param np an optional sequence of named parameters among the ones listed below; what a format has no use for is
///   passed over
///
/// \cgalNamedParamsBegin
///   \wireframeParamInputFormat
///   \wireframeParamCoordinateProperties
///   \cgalParamNBegin{distance_property}
///     \cgalParamDescription{the name of the property or column that holds the distances; of text without names,
///                           the number of the column, counted from 1}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{the first that is there of `distance`, `distances`, `sharpness`, `scalar_distance`,
///                       `quality`; of text without names, the fourth column}
///     \cgalParamExtra{A name that differs in case only is taken if there is no exact match, and then one behind
///                     `scalar_`, as CloudCompare writes them.}
///   \cgalParamNEnd
///   \cgalParamNBegin{points_dataset}
///     \cgalParamDescription{the name of the data set of HDF5, or the array of `.npz`, that holds the points}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{`points`}
///     \cgalParamExtra{One within groups is named with its path, `group/points`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{distances_dataset}
///     \cgalParamDescription{the same for the distances}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{what `distance_property` says}
///   \cgalParamNEnd
///   \wireframeParamClampNegative
///   \wireframeParamSkipInvalidOfFile
///   \cgalParamNBegin{number_of_skipped}
///     \cgalParamDescription{receives the number of points that were left out}
///     \cgalParamType{`std::size_t*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong, where in the file, and what helps; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if the cloud was read and has at least one point, else `false`: the file does not exist or
///   cannot be read, its extension is unknown or needs a library that is not there, it is malformed, truncated or
///   empty, its distances are missing, or it has points that cannot be used and `skip_invalid` is `false`.
///
/// Reading takes time linear in the size of the file, and memory for the points that are there (whatever
/// number a header promises).
template <class Point, class FT, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_distance_cloud(const std::string& filename, std::vector<std::pair<Point, FT>>& cloud,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::read_distance_cloud_of_files(filename, nullptr, cloud, np);
}

/// \ingroup PkgWireframeExtractionIO
/// reads a point cloud from one file and the distances of its points from another.
///
/// The cloud may be in any format of the other overload, but only its coordinates are looked at: a text file
/// needs three columns, a PLY or PCD file `x`, `y` and `z`, an array `.npy` three columns, and `.npz` and HDF5 files
/// the points only. The file of distances has one number per point, in the order of the points. It is
/// - an array in a file `.npy`, `.npz` or HDF5, or
/// - whatever its extension otherwise is, text with one number per line; blank lines, comments that start with `#` or
///   `//`, and one line with a name at its top are allowed.
///
/// \tparam Point a type constructible from three `double` coordinates
/// \tparam FT a model of `FieldNumberType` that is constructible from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file of the cloud
/// \param distances_filename the name of the file of the distances
/// \param cloud the points and their distances, in the order of the files. What it held before is replaced;
///   it is left as it was if reading fails.
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \wireframeParamInputFormat
///   \wireframeParamCoordinateProperties
///   \cgalParamNBegin{points_dataset}
///     \cgalParamDescription{the name of the data set of HDF5, or the array of `.npz`, that holds the points}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{`points`}
///   \cgalParamNEnd
///   \cgalParamNBegin{distances_dataset}
///     \cgalParamDescription{the same for the distances}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{the first that is there of `distance`, `distances`, `sharpness`, `scalar_distance`,
///                       `quality`}
///   \cgalParamNEnd
///   \wireframeParamClampNegative
///   \wireframeParamSkipInvalidOfFile
///   \cgalParamNBegin{number_of_skipped}
///     \cgalParamDescription{receives the number of points that were left out}
///     \cgalParamType{`std::size_t*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong, where in the file, and what helps; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if the cloud was read and has at least one point, else `false`: for the reasons of the
///   other overload, or because the two files differ in their number of points.
///
/// Reading takes time linear in the size of the files, and memory for the points that are there.
template <class Point, class FT, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_distance_cloud(const std::string& filename, const std::string& distances_filename,
                         std::vector<std::pair<Point, FT>>& cloud,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::read_distance_cloud_of_files(filename, &distances_filename, cloud, np);
}

/// \ingroup PkgWireframeExtractionIO
/// reads a point cloud with a distance per point out of a stream.
///
/// \tparam Point a type constructible from three `double` coordinates
/// \tparam FT a model of `FieldNumberType` that is constructible from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream; opened with `std::ios::binary` unless its format is text
/// \param format the extension that a file of the format has, with or without the dot, such as "ply"; that of HDF5 is
///   not possible
/// \param cloud the points and their distances, in their order. What it held before is replaced; it is left as it was
///   if reading fails.
/// \param np an optional sequence of named parameters, those of the overload for a file
///
/// \return `true` if the cloud was read and has at least one point, else `false`, for the reasons of the overload for a
///   file.
template <class Point, class FT, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_distance_cloud(std::istream& stream, const std::string& format, std::vector<std::pair<Point, FT>>& cloud,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const auto read = [&](const internal::Cloud_reader_options& options, internal::Sample_sink& sink,
                        std::size_t& number_of_skipped) {
    return internal::read_cloud_stream(stream, format, options, internal::available_cloud_libraries(), sink,
                                       number_of_skipped);
  };
  return internal::read_distance_cloud_by(read, "the stream", cloud, np);
}

/// \ingroup PkgWireframeExtractionIO
/// reads a point cloud with a distance per point from one file, and writes it to an output iterator. Nothing is written
/// if reading fails.
///
/// \tparam Value the type that is written, a `std::pair` of a point and a distance as in the overload for a vector
/// \tparam OutputIterator a model of `OutputIterator` that accepts `Value`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param out the output iterator
/// \param np an optional sequence of named parameters, those of the overload for a vector
///
/// \return `true` if the cloud was read and has at least one point, else `false`, for the reasons of the overload for a
///   vector.
template <class Value, class OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifdef DOXYGEN_RUNNING
bool
#else
typename std::enable_if<internal::Is_iterator<OutputIterator>::value, bool>::type
#endif
read_distance_cloud(const std::string& filename, OutputIterator out,
                    const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  std::vector<Value> cloud;
  if (!read_distance_cloud(filename, cloud, np))
    return false;
  std::move(cloud.begin(), cloud.end(), out);
  return true;
}

/// \ingroup PkgWireframeExtractionIO
/// reads a point cloud with a distance per point from one file, and writes it to an output iterator whose value type is
/// known, such as `std::back_inserter(list)`. Nothing is written if reading fails.
///
/// \tparam OutputIterator a model of `OutputIterator` whose value type, as `CGAL::value_type_traits` has it, is a
///   `std::pair` of a point and a distance
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param out the output iterator
/// \param np an optional sequence of named parameters, those of the overload for a vector
///
/// \return `true` if the cloud was read and has at least one point, else `false`, for the reasons of the overload for a
///   vector.
template <class OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifdef DOXYGEN_RUNNING
bool
#else
typename std::enable_if<internal::Is_iterator<OutputIterator>::value, bool>::type
#endif
read_distance_cloud(const std::string& filename, OutputIterator out,
                    const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return read_distance_cloud<typename CGAL::value_type_traits<OutputIterator>::type>(filename, out, np);
}

/// \ingroup PkgWireframeExtractionIO
/// reads a point cloud with a distance per point from one file into a point set, whose property map `distance`, of type
/// `double`, gets the distances; `extract_wireframe(points)` finds it there. The header `CGAL/Point_set_3.h` has to be
/// included.
///
/// \tparam Point a type constructible from three `double` coordinates
/// \tparam Vector the type of normals
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param points the points. What the set held before is replaced, with all of its properties; it is left as it was if
///   reading fails.
/// \param np an optional sequence of named parameters, those of the overload for a vector
///
/// \return `true` if the cloud was read and has at least one point, else `false`, for the reasons of the overload for a
///   vector.
template <class Point, class Vector, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_distance_cloud(const std::string& filename, CGAL::Point_set_3<Point, Vector>& points,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  std::vector<std::pair<Point, double>> cloud;
  if (!read_distance_cloud(filename, cloud, np))
    return false;
  CGAL::Point_set_3<Point, Vector> result;
  auto distances = result.template add_property_map<double>("distance", 0.).first;
  result.reserve(cloud.size());
  for (const std::pair<Point, double>& sample : cloud)
    put(distances, *result.insert(sample.first), sample.second);
  points = result;
  return true;
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_READ_DISTANCE_CLOUD_H
