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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_FORMATS_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_FORMATS_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Array_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Inflater.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Npy_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Npz_file.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Off_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Pcd_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Ply_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Text_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/cloud_formats.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/read_separate_distances.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cstddef>
#include <fstream>
#include <istream>
#include <memory>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

enum class Cloud_format
{
  PLY,
  TEXT,
  PCD,
  OFF,
  NPY,
  NPZ,
  HDF5,
  UNKNOWN
};

CGAL_WIREFRAME_EXTRACTION_INLINE
Cloud_format find_cloud_format(const std::string& extension)
{
  static const struct
  {
    const char* extension;
    Cloud_format format;
  } formats[] = {{".ply", Cloud_format::PLY},  {".xyz", Cloud_format::TEXT}, {".txt", Cloud_format::TEXT},
                 {".csv", Cloud_format::TEXT}, {".asc", Cloud_format::TEXT}, {".pts", Cloud_format::TEXT},
                 {".pcd", Cloud_format::PCD},  {".off", Cloud_format::OFF},  {".npy", Cloud_format::NPY},
                 {".npz", Cloud_format::NPZ},  {".h5", Cloud_format::HDF5},  {".hdf5", Cloud_format::HDF5}};
  for (const auto& known : formats)
    if (extension == known.extension)
      return known.format;
  return Cloud_format::UNKNOWN;
}

// Opens a file of named arrays; returns nothing, and says why, if that is impossible.
CGAL_WIREFRAME_EXTRACTION_INLINE
std::unique_ptr<Array_file> open_array_file(Cloud_format format, const std::string& filename, std::istream& stream,
                                            const Cloud_libraries& libraries, std::string& error)
{
  if (format == Cloud_format::NPZ)
  {
    std::unique_ptr<Npz_file> file(new Npz_file(stream, filename, libraries));
    return std::unique_ptr<Array_file>(file->open(error) ? file.release() : nullptr);
  }
  if (libraries.open_hdf5 == nullptr)
    error = filename
      + ": its format needs HDF5, without which this program was built; build it "
        "with the CMake target CGAL::Wireframe_extraction_HDF5 (Debian: libhdf5-dev)";
  else if (stream.peek() == std::istream::traits_type::eof())
    error = filename + ": " + empty_file_text();
  else
    return libraries.open_hdf5(filename, error);
  return nullptr;
}

template <class Reader>
std::string take_results(const Reader& reader, std::size_t& number_of_skipped)
{
  number_of_skipped = reader.filter().number_of_invalid();
  return reader.error();
}

template <class Reader>
std::string read_with(std::istream& stream, const std::string& filename, const Cloud_reader_options& options,
                      Sample_sink& sink, std::size_t& number_of_skipped)
{
  Reader reader(stream, filename, options);
  reader.read(sink);
  return take_results(reader, number_of_skipped);
}

// Reads a cloud of a format that is known out of an open stream, as `read_cloud()` does.
CGAL_WIREFRAME_EXTRACTION_INLINE
std::string read_cloud_of_format(Cloud_format format, std::istream& stream, const std::string& filename,
                                 const Cloud_reader_options& options, const Cloud_libraries& libraries,
                                 Sample_sink& sink, std::size_t& number_of_skipped)
{
  switch (format)
  {
  case Cloud_format::PLY: {
    Ply_cloud_reader reader(stream, filename, options);
    if (reader.read_header())
    {
      sink.reserve(reader.trusted_number_of_vertices());
      reader.read(sink);
    }
    return take_results(reader, number_of_skipped);
  }
  case Cloud_format::TEXT: return read_with<Text_cloud_reader>(stream, filename, options, sink, number_of_skipped);
  case Cloud_format::PCD: return read_with<Pcd_cloud_reader>(stream, filename, options, sink, number_of_skipped);
  case Cloud_format::OFF: return read_with<Off_cloud_reader>(stream, filename, options, sink, number_of_skipped);
  case Cloud_format::NPY: {
    File_bytes bytes(stream);
    Npy_reader npy(bytes, filename);
    Number_array array;
    if (!npy.read(array))
      return npy.error();
    Array_cloud_reader reader(options);
    reader.read(filename, array, sink);
    return take_results(reader, number_of_skipped);
  }
  default:
    std::string error;
    const std::unique_ptr<Array_file> file = open_array_file(format, filename, stream, libraries, error);
    if (file == nullptr)
      return error;
    Array_cloud_reader reader(options);
    reader.read(*file, sink);
    return take_results(reader, number_of_skipped);
  }
}

CGAL_WIREFRAME_EXTRACTION_INLINE
std::string read_cloud(const std::string& filename, const Cloud_reader_options& options,
                       const Cloud_libraries& libraries, Sample_sink& sink, std::size_t& number_of_skipped)
{
  const std::string extension = format_extension(options.format, filename);
  const Cloud_format format = find_cloud_format(extension);
  for (const char* const other : {".las", ".laz", ".e57"})
    if (extension == other)
      return filename + ": " + extension + " is not read; convert it to .ply, by CloudCompare or "
        + "\"pdal translate CLOUD" + extension + " CLOUD.ply\" (Debian: cloudcompare, pdal)";
  if (format == Cloud_format::UNKNOWN)
    return filename + ": unknown " + (options.format.empty() ? "extension " : "format ") + quote(extension)
      + " of a point cloud; known are .ply .pcd .off .npy .npz .h5 .hdf5 and .xyz .txt .csv .asc .pts (text)";
  std::ifstream stream;
  std::string error;
  if (!open_input_file(filename, stream, error))
    return error;
  return read_cloud_of_format(format, stream, filename, options, libraries, sink, number_of_skipped);
}

CGAL_WIREFRAME_EXTRACTION_INLINE
std::string read_cloud_stream(std::istream& stream, const std::string& extension, const Cloud_reader_options& options,
                              const Cloud_libraries& libraries, Sample_sink& sink, std::size_t& number_of_skipped)
{
  const std::string name = "the stream";
  const Cloud_format format = find_cloud_format(format_extension(extension, name));
  if (format == Cloud_format::UNKNOWN || format == Cloud_format::HDF5)
    return name + ": unknown format " + quote(extension)
      + " of a stream; known are ply, pcd, off, npy, npz and xyz, txt, csv, asc, pts (text)";
  if (!stream)
    return name + ": cannot be read";
  return read_cloud_of_format(format, stream, name, options, libraries, sink, number_of_skipped);
}

CGAL_WIREFRAME_EXTRACTION_INLINE
std::string read_distances_file(const std::string& filename, const Cloud_reader_options& options,
                                const Cloud_libraries& libraries, Separate_distances& distances)
{
  std::ifstream stream;
  std::string error;
  if (!open_input_file(filename, stream, error))
    return error;
  const Cloud_format format = find_cloud_format(lower_extension(filename));
  if (format != Cloud_format::NPY && format != Cloud_format::NPZ && format != Cloud_format::HDF5)
  {
    read_separate_distances(stream, filename, distances, error);
    return error;
  }
  Number_array array;
  if (format == Cloud_format::NPY)
  {
    File_bytes bytes(stream);
    Npy_reader reader(bytes, filename);
    if (!reader.read(array))
      return reader.error();
  }
  else
  {
    const std::unique_ptr<Array_file> file = open_array_file(format, filename, stream, libraries, error);
    if (file == nullptr)
      return error;
    std::size_t index;
    if (!Array_cloud_reader::find_distances(*file, options, index))
      return Array_cloud_reader::no_distances_text(*file, options);
    if (!file->read(file->names()[index], array, error))
      return error;
  }
  if (array.values.empty())
    return filename + ": holds no distances; write one for each point into it";
  distances.filename = filename;
  distances.values.swap(array.values);
  return std::string();
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_FORMATS_IMPL_H
