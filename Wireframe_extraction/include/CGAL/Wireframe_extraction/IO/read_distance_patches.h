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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_READ_DISTANCE_PATCHES_H
#define CGAL_WIREFRAME_EXTRACTION_IO_READ_DISTANCE_PATCHES_H

#include <CGAL/Wireframe_extraction/Distance_patch.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/available_cloud_libraries.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/cloud_formats.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// puts samples at the end of a patch
template <class Point, class FT>
class Patch_sink : public Sample_sink
{
public:
  explicit Patch_sink(CGAL::Wireframe_extraction::Distance_patch<Point, FT>& patch) : m_patch(patch) {}

  void reserve(std::size_t count) override { m_patch.samples.reserve(count); }

  bool operator()(const Distance_sample* first, const Distance_sample* last) override
  {
    for (; first != last; ++first)
    {
      m_patch.samples.emplace_back(Point(first->x, first->y, first->z), FT(first->distance));
      if (first->index != Distance_sample::no_index)
        m_patch.indices.push_back(static_cast<std::size_t>(first->index));
    }
    return true;
  }

private:
  CGAL::Wireframe_extraction::Distance_patch<Point, FT>& m_patch;
};

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// reads files with parts of a cloud, which may overlap, and which `Wireframe_extraction::fuse_distance_patches()`
/// puts together.
///
/// Each file may be in any format of `read_distance_cloud()`. HDF5 and `.npz` files may also hold the indices of the
/// points in the whole cloud, in an array with one index per point.
///
/// \tparam FilenameRange a range of file names, convertible to `std::string`
/// \tparam Point a type constructible from three `double` coordinates
/// \tparam FT a model of `FieldNumberType` that is constructible from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filenames the names of the files
/// \param patches one patch per file, in the order of the names, even if a file holds several patches, which makes no
///   difference to the fusion. What it held before is replaced; it is left as it was if reading fails.
/// \param np an optional sequence of named parameters: those of `read_distance_cloud()`, where `number_of_skipped` is
///   the number in all files, and the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{use_indices}
///     \cgalParamDescription{whether indices are looked for}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{indices_dataset}
///     \cgalParamDescription{the name of the data set or array that holds the indices}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{the first that is there of `indices` and `indexes_in_whole`; there may be none}
///     \cgalParamExtra{If it is given, every HDF5 or `.npz` file has to have it.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all files were read, else `false`: there are none, or one of them cannot be read, for the
///   reasons of `read_distance_cloud()`.
///
/// Reading takes time linear in the size of the files, and memory for the points that are there.
template <class FilenameRange, class Point, class FT, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_distance_patches(const FilenameRange& filenames,
                           std::vector<CGAL::Wireframe_extraction::Distance_patch<Point, FT>>& patches,
                           const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;

  internal::Cloud_reader_options options = internal::get_cloud_reader_options<FT>(np);
  options.reads_indices = choose_parameter(get_parameter(np, internal_np::use_indices), true);
  options.indices_dataset = choose_parameter(get_parameter_reference(np, internal_np::indices_dataset), std::string());

  std::vector<CGAL::Wireframe_extraction::Distance_patch<Point, FT>> result;
  std::size_t number_of_skipped = 0;
  std::string error;
  for (const std::string& filename : filenames)
  {
    error = internal::read_in_memory(filename, [&] {
      std::size_t skipped_here = 0;
      result.emplace_back();
      internal::Patch_sink<Point, FT> sink(result.back());
      const std::string reason =
        internal::read_cloud(filename, options, internal::available_cloud_libraries(), sink, skipped_here);
      number_of_skipped += skipped_here;
      return reason;
    });
    if (!error.empty())
      break;
  }
  if (error.empty() && result.empty())
    error = "there are no names of files with patches";
  if (error.empty())
    patches.swap(result);

  std::size_t* const skipped =
    choose_parameter(get_parameter(np, internal_np::number_of_skipped), static_cast<std::size_t*>(nullptr));
  if (skipped != nullptr)
    *skipped = (error.empty() ? number_of_skipped : 0);
  return internal::report(np, error);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_READ_DISTANCE_PATCHES_H
