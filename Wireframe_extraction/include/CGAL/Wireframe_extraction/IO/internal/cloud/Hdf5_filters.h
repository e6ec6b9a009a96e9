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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_HDF5_FILTERS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_HDF5_FILTERS_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Lzf_decoder.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <CGAL/config.h>

#include <hdf5.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// The filter `lzf` of h5py, for reading only. The interface is that of the HDF5 library: nothing
// is returned on failure.
inline std::size_t undo_hdf5_lzf(unsigned int flags, std::size_t number_of_values, const unsigned int* values,
                                 std::size_t size, std::size_t* size_of_buffer, void** buffer)
{
  const Lzf_decoder decoder(static_cast<const unsigned char*>(*buffer), size);
  std::size_t decoded_size = 0;
  if ((flags & H5Z_FLAG_REVERSE) == 0 || !decoder.find_size(decoded_size) || decoded_size == 0)
    return 0;
  // the third value, if there is one, is the size of a whole chunk, which the library reads without looking
  if (number_of_values > 2 && values[2] != 0 && values[2] != decoded_size)
    return 0;
  void* const decoded = H5allocate_memory(decoded_size, false);
  if (decoded == nullptr)
    return 0;
  decoder.decode(static_cast<unsigned char*>(decoded));
  H5free_memory(*buffer);
  *buffer = decoded;
  *size_of_buffer = decoded_size;
  return decoded_size;
}

// Has the HDF5 library read what h5py compressed with its own filter, unless it can anyway, by a plugin. The filter
// says that it can also compress, which then fails: so whoever writes with it in this program gets data as they are,
// instead of no data set at all.
inline void register_hdf5_lzf()
{
  constexpr H5Z_filter_t number = 32000; // as it is registered with The HDF Group
  const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, number, 1, 1, "lzf", nullptr, nullptr, &undo_hdf5_lzf};
  if (H5Zfilter_avail(number) <= 0)
    H5Zregister(&filter);
}

// Names the filter of a data set that is needed to read it and is not there, or nothing.
inline std::string missing_hdf5_filter(hid_t properties)
{
  const int count = H5Pget_nfilters(properties);
  for (int i = 0; i < count; ++i)
  {
    unsigned int flags = 0, info = 0;
    std::size_t number_of_values = 0;
    char name[64] = "";
    const H5Z_filter_t filter = H5Pget_filter2(properties, static_cast<unsigned int>(i), &flags, &number_of_values,
                                               nullptr, sizeof(name), name, &info);
    name[sizeof(name) - 1] = '\0';
    if (filter >= 0 && H5Zfilter_avail(filter) <= 0)
      return (*name != '\0' ? printable(name, sizeof(name)) + ", " : std::string()) + "number "
        + std::to_string(filter);
  }
  return std::string();
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_HDF5_FILTERS_H
