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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_DISTANCE_CLOUD_FILE_H
#define CGAL_WIREFRAME_EXTRACTION_IO_DISTANCE_CLOUD_FILE_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/available_cloud_libraries.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/cloud_formats.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgWireframeExtractionIO

A point cloud, with a distance per point or without, that stays in its file, for clouds that are larger than the memory.
The formats, and what makes a file wrong, are those of `read_distance_cloud()`.

Files in the formats PLY, text, PCD, OFF and HDF5 are read chunk by chunk. Arrays of `.npy` and `.npz` files, and
distances in a file of their own, are in memory while the cloud is read. The file is opened anew each time, so it
cannot be a pipe.
*/
class Distance_cloud_file : public Wireframe_extraction::Distance_cloud_source
{
public:
  /// takes the points and the distances from one file. The constructor reads nothing, and so cannot fail.
  ///
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param filename the name of the file
  /// \param np an optional sequence of named parameters among the ones listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{field_origin}
  ///     \cgalParamDescription{where the distances come from. Unless it is `GIVEN`, the file need not have any, and
  ///                           `has_distances()` tells whether they are known.}
  ///     \cgalParamType{`Wireframe_extraction::Field_origin`}
  ///     \cgalParamDefault{`Wireframe_extraction::Field_origin::GIVEN`}
  ///     \cgalParamExtra{Of text without names, three columns have no distances, six neither if the last three look
  ///                     like a normal, and more neither if the fourth to the sixth look like a color.}
  ///   \cgalParamNEnd
  ///   \wireframeParamInputFormat
  ///   \wireframeParamCoordinateProperties
  ///   \cgalParamNBegin{distance_property}
  ///     \cgalParamDescription{the name of the property or column that holds the distances}
  ///     \cgalParamType{`std::string`}
  ///     \cgalParamDefault{the first that is there of `distance`, `distances`, `sharpness`, `scalar_distance`,
  ///                       `quality`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{points_dataset}
  ///     \cgalParamDescription{the name of the data set of HDF5, or the array of `.npz`, that holds the points}
  ///     \cgalParamType{`std::string`}
  ///     \cgalParamDefault{`points`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{distances_dataset}
  ///     \cgalParamDescription{the same for the distances}
  ///     \cgalParamType{`std::string`}
  ///     \cgalParamDefault{what `distance_property` says}
  ///   \cgalParamNEnd
  ///   \wireframeParamClampNegative
  ///   \wireframeParamSkipInvalidOfFile
  /// \cgalNamedParamsEnd
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  explicit Distance_cloud_file(const std::string& filename,
                               const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
    : m_filename(filename), m_options(internal::get_cloud_reader_options<double>(np))
  {
    m_options.field_origin = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, Wireframe_extraction::internal_np::field_origin),
      Wireframe_extraction::Field_origin::GIVEN);
    m_options.may_be_estimated = true;
  }

  /// takes the points from one file and the distances from another. The constructor reads nothing, and so cannot fail.
  ///
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param filename the name of the file with the points
  /// \param distances_filename the name of the file with the distances
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
  /// \cgalNamedParamsEnd
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  Distance_cloud_file(const std::string& filename, const std::string& distances_filename,
                      const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
    : m_filename(filename), m_distances_filename(distances_filename), m_has_distances_file(true),
      m_options(internal::get_cloud_reader_options<double>(np))
  {}

  /// reads the file from its beginning.
  bool read(const Sink& sink) override
  {
    m_error = internal::read_in_memory(m_filename, [&] { return read_file(sink); });
    return m_error.empty();
  }

  /// returns what is wrong with the file, where, and what helps; empty if nothing is.
  std::string error_message() const override { return m_error; }

  /// returns whether the distances are known; before the file was read, whether they have to be.
  bool has_distances() const override { return m_has_distances; }

  /// returns what was assumed about the columns of the file where it does not say it; empty if nothing was, and before
  /// it was read.
  const std::string& assumption() const { return m_assumption; }

  /// returns what of the file holds the distances, such as `column 4`, in words for people; empty if nothing does, if
  /// they are in a file of their own, and before the file was read.
  const std::string& distance_place() const { return m_distance_place; }

  /// returns how many points were left out when the file was read last, since they are invalid.
  std::size_t number_of_skipped() const { return m_number_of_skipped; }

private:
  /// \cond SKIP_IN_MANUAL
  // turns the samples of the readers into those of a source
  class Chunk_sink : public internal::Sample_sink
  {
  public:
    Chunk_sink(const Sink& sink, bool& has_distances, std::string& assumption, std::string& place)
      : m_sink(sink), m_has_distances(has_distances), m_assumption(assumption), m_place(place)
    {}

    void describe(bool has_distances, const std::string& assumption, const std::string& place) override
    {
      m_has_distances = has_distances;
      m_assumption = assumption;
      m_place = place;
    }

    bool operator()(const internal::Distance_sample* first, const internal::Distance_sample* last) override
    {
      m_chunk.clear();
      for (; first != last; ++first)
        m_chunk.push_back(Sample{first->x, first->y, first->z, first->distance});
      m_is_stopped = !m_sink(m_chunk.data(), m_chunk.data() + m_chunk.size());
      return !m_is_stopped;
    }

    bool is_stopped() const { return m_is_stopped; }

  private:
    const Sink& m_sink;
    bool& m_has_distances;
    std::string &m_assumption, &m_place;
    std::vector<Sample> m_chunk;
    bool m_is_stopped = false;
  };
  /// \endcond

  // returns what went wrong, nothing if all went well
  std::string read_file(const Sink& sink)
  {
    internal::Separate_distances distances;
    internal::Cloud_reader_options options = m_options;
    const internal::Cloud_libraries libraries = internal::available_cloud_libraries();
    if (m_has_distances_file)
    {
      const std::string error = internal::read_distances_file(m_distances_filename, options, libraries, distances);
      if (!error.empty())
        return error;
      options.distances = &distances;
    }
    Chunk_sink chunks(sink, m_has_distances, m_assumption, m_distance_place);
    const std::string error = internal::read_cloud(m_filename, options, libraries, chunks, m_number_of_skipped);
    return chunks.is_stopped() ? std::string() : error;
  }

  std::string m_filename, m_distances_filename, m_assumption, m_distance_place;
  bool m_has_distances_file = false, m_has_distances = true;
  internal::Cloud_reader_options m_options;
  std::string m_error;
  std::size_t m_number_of_skipped = 0;
};

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_DISTANCE_CLOUD_FILE_H
