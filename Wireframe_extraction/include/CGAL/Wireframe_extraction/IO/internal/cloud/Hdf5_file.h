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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_HDF5_FILE_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_HDF5_FILE_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Array_file.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Hdf5_filters.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <CGAL/config.h>

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// keeps an identifier of the HDF5 library, and gives it back
class Hdf5_handle
{
public:
  Hdf5_handle(hid_t id, herr_t (*close)(hid_t)) : m_id(id), m_close(close) {}
  Hdf5_handle(const Hdf5_handle&) = delete;
  Hdf5_handle& operator=(const Hdf5_handle&) = delete;

  ~Hdf5_handle()
  {
    if (m_id >= 0)
      m_close(m_id);
  }

  bool is_valid() const { return m_id >= 0; }
  hid_t get() const { return m_id; }

private:
  hid_t m_id;
  herr_t (*m_close)(hid_t);
};

// As long as it is there, the HDF5 library does not print its errors; afterwards it does what it did before.
class Hdf5_silence
{
public:
  Hdf5_silence()
  {
    H5open();
    H5Eget_auto2(H5E_DEFAULT, &m_function, &m_data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }

  Hdf5_silence(const Hdf5_silence&) = delete;
  Hdf5_silence& operator=(const Hdf5_silence&) = delete;
  ~Hdf5_silence() { H5Eset_auto2(H5E_DEFAULT, m_function, m_data); }

private:
  H5E_auto2_t m_function = nullptr;
  void* m_data = nullptr;
};

// The data sets of an HDF5 file.
class Hdf5_file : public Array_file
{
public:
  explicit Hdf5_file(const std::string& filename) : m_filename(filename), m_file(open_file(filename), &H5Fclose) {}

  bool open(std::string& error)
  {
    if (!m_file.is_valid())
    {
      const std::string reason = reason_of_library();
      error = m_filename + ": is no HDF5 file, or a truncated or damaged one"
        + (reason.empty() ? "" : " (" + reason + ")") + "; get a complete copy of the file";
      return false;
    }
    register_hdf5_lzf();
    collect_names(m_file.get(), "", 0);
    return true;
  }

  const std::string& filename() const override { return m_filename; }
  const char* word_for_array() const override { return "data set"; }
  const std::vector<std::string>& names() const override { return m_names; }

  std::string contents_text() override
  {
    std::string text;
    const std::size_t count = (std::min)(m_names.size(), std::size_t(20));
    for (std::size_t i = 0; i < count; ++i)
    {
      const Hdf5_handle dataset(H5Dopen2(m_file.get(), m_names[i].c_str(), H5P_DEFAULT), &H5Dclose);
      std::vector<std::uint64_t> shape;
      text += (text.empty() ? "" : ", ") + printable(m_names[i]);
      if (find_shape(dataset, shape))
        text += " (" + shape_text(shape) + ")";
    }
    if (m_names.size() > count)
      text += " and " + std::to_string(m_names.size() - count) + " more";
    return text.empty() ? "no data set at all" : text;
  }

  bool find_rows(const std::string& name, std::vector<std::uint64_t>& shape) override
  {
    const Hdf5_handle dataset(H5Dopen2(m_file.get(), name.c_str(), H5P_DEFAULT), &H5Dclose);
    if (!find_shape(dataset, shape) || shape.empty())
      return false;
    const Hdf5_handle type(H5Dget_type(dataset.get()), &H5Tclose);
    std::uint64_t count;
    return type.is_valid() && is_number(type.get()) && check_content(dataset.get(), type.get(), shape, count).empty();
  }

  bool read_rows(const std::string& name, std::uint64_t first, std::uint64_t count, std::vector<double>& values,
                 std::string& error) override
  {
    const Hdf5_handle dataset(H5Dopen2(m_file.get(), name.c_str(), H5P_DEFAULT), &H5Dclose);
    std::vector<std::uint64_t> shape;
    std::uint64_t size = 0;
    bool is_read = find_shape(dataset, shape) && !shape.empty() && find_number_of_values(shape, size);
    if (is_read)
    {
      values.resize(static_cast<std::size_t>(size / shape[0] * count));
      is_read = read_slab(dataset.get(), shape, first, count, [&](hid_t memory, hid_t space) {
        return H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data());
      });
    }
    if (!is_read)
      error = m_filename + ": its data set " + quote(name) + " " + failed_at(first);
    return is_read;
  }

  bool read(const std::string& name, Number_array& array, std::string& error) override
  {
    const std::string reason = read_dataset(name, array);
    if (!reason.empty())
      error = m_filename + ": its data set " + quote(name) + " " + reason;
    return reason.empty();
  }

private:
  static constexpr std::size_t largest_number_of_objects = 10000;
  static constexpr int largest_depth = 4;
  static constexpr std::size_t largest_number_of_columns = 4096;
  static constexpr std::uint64_t values_per_slab = std::uint64_t(1) << 20;
  static constexpr std::uint64_t rows_per_slab = 64;
  // no filter of HDF5 that is in use makes data smaller by more
  static constexpr std::uint64_t largest_compression = 2048;

  static hid_t open_file(const std::string& filename) { return H5Fopen(filename.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT); }

  // what the library says first about its last error
  static std::string reason_of_library()
  {
    std::string text;
    const H5E_walk2_t keep = [](unsigned, const H5E_error2_t* error, void* target) {
      std::string& reason = *static_cast<std::string*>(target);
      if (reason.empty() && error->desc != nullptr)
        reason = printable(error->desc, 120);
      return herr_t(0);
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep, &text);
    return text;
  }

  void collect_names(hid_t group, const std::string& prefix, int depth)
  {
    H5G_info_t info;
    if (H5Gget_info(group, &info) < 0)
      return;
    for (hsize_t i = 0; i < info.nlinks && m_number_of_visited < largest_number_of_objects; ++i)
    {
      ++m_number_of_visited; // groups may contain each other
      char buffer[256];
      const ssize_t size =
        H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, buffer, sizeof(buffer), H5P_DEFAULT);
      if (size <= 0 || size >= static_cast<ssize_t>(sizeof(buffer)))
        continue;
      const std::string name(buffer, static_cast<std::size_t>(size));
      const Hdf5_handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), &H5Oclose);
      if (!object.is_valid())
        continue;
      const H5I_type_t type = H5Iget_type(object.get());
      if (type == H5I_DATASET)
        m_names.push_back(prefix + name);
      else if (type == H5I_GROUP && depth < largest_depth)
        collect_names(object.get(), prefix + name + "/", depth + 1);
    }
  }

  static bool find_shape(const Hdf5_handle& dataset, std::vector<std::uint64_t>& shape)
  {
    if (!dataset.is_valid())
      return false;
    const Hdf5_handle space(H5Dget_space(dataset.get()), &H5Sclose);
    const int rank = space.is_valid() ? H5Sget_simple_extent_ndims(space.get()) : -1;
    if (rank < 0)
      return false;
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank) + 1);
    if (H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr) < 0)
      return false;
    shape.assign(sizes.begin(), sizes.end() - 1);
    return true;
  }

  static bool is_number(hid_t type)
  {
    const H5T_class_t kind = H5Tget_class(type);
    return kind == H5T_FLOAT || kind == H5T_INTEGER;
  }

  // what a data set claims to take, but no more than the file has
  std::uint64_t stored_size(hid_t dataset) const
  {
    hsize_t size_of_file = 0;
    H5Fget_filesize(m_file.get(), &size_of_file);
    return (std::min)(std::uint64_t(H5Dget_storage_size(dataset)), std::uint64_t(size_of_file));
  }

  static bool refers_to_other_files(hid_t properties)
  {
    return H5Pget_layout(properties) == H5D_VIRTUAL || H5Pget_external_count(properties) > 0;
  }

  // returns what went wrong, nothing if all went well
  std::string read_dataset(const std::string& name, Number_array& array)
  {
    const Hdf5_handle dataset(H5Dopen2(m_file.get(), name.c_str(), H5P_DEFAULT), &H5Dclose);
    if (!find_shape(dataset, array.shape))
      return "cannot be opened: " + reason_of_library();
    const Hdf5_handle type(H5Dget_type(dataset.get()), &H5Tclose);
    if (!type.is_valid())
      return "has no type: " + reason_of_library();
    if (H5Tget_class(type.get()) == H5T_VLEN)
    {
      const Hdf5_handle base(H5Tget_super(type.get()), &H5Tclose);
      if (base.is_valid() && is_number(base.get()) && array.shape.size() == 1)
        return read_ragged(dataset.get(), type.get(), array);
    }
    const bool is_structured = H5Tget_class(type.get()) == H5T_COMPOUND && array.shape.size() == 1;
    if (!is_structured && !is_number(type.get()))
      return "holds no numbers; floating point numbers or integers are needed";
    std::uint64_t count = 0;
    const std::string reason = check_content(dataset.get(), type.get(), array.shape, count);
    if (!reason.empty())
      return reason;
    return is_structured ? read_structures(dataset.get(), type.get(), array)
                         : read_all_rows(dataset.get(), H5T_NATIVE_DOUBLE, array, count);
  }

  // What h5py writes of structured arrays: the numbers of each structure are a row, all else is passed over.
  static std::string read_structures(hid_t dataset, hid_t file_type, Number_array& array)
  {
    const int number_of_members = H5Tget_nmembers(file_type);
    std::vector<unsigned> numbers;
    for (int i = 0; i < number_of_members; ++i)
    {
      const Hdf5_handle member(H5Tget_member_type(file_type, static_cast<unsigned>(i)), &H5Tclose);
      if (member.is_valid() && is_number(member.get()))
        numbers.push_back(static_cast<unsigned>(i));
    }
    if (numbers.empty() || numbers.size() > largest_number_of_columns)
      return "holds no numbers; floating point numbers or integers are needed";
    const Hdf5_handle type(H5Tcreate(H5T_COMPOUND, numbers.size() * sizeof(double)), &H5Tclose);
    for (const unsigned i : numbers)
    {
      char* const name = H5Tget_member_name(file_type, i);
      if (name == nullptr || H5Tinsert(type.get(), name, array.columns.size() * sizeof(double), H5T_NATIVE_DOUBLE) < 0)
        return "has members that cannot be read: " + reason_of_library();
      array.columns.push_back(name);
      H5free_memory(name);
    }
    array.shape.push_back(numbers.size());
    const std::vector<std::uint64_t> rows = {array.shape[0]};
    return read_all_rows(dataset, type.get(), array, array.shape[0] * numbers.size(), &rows);
  }

  // whether an array of numbers can be as large as it says; gets the number of its values
  std::string check_content(hid_t dataset, hid_t type, const std::vector<std::uint64_t>& shape,
                            std::uint64_t& count) const
  {
    const std::uint64_t bytes = H5Tget_size(type);
    const std::uint64_t there = stored_size(dataset);
    const Hdf5_handle properties(H5Dget_create_plist(dataset), &H5Pclose);
    if (!properties.is_valid())
      return "has no properties: " + reason_of_library();
    const std::string filter = missing_hdf5_filter(properties.get());
    if (!filter.empty())
      return "is compressed by a filter that this HDF5 library does not have (" + filter
        + "); install the plugin for it, or write the file anew: h5repack -f GZIP=4 OLD NEW";
    if (refers_to_other_files(properties.get()))
      return "has its data in other files; put it into one, as h5py does if a new data set gets the array of the "
             "old one";
    if (!find_number_of_values(shape, count) || (count > 0 && count > there * largest_compression / bytes))
      return "promises the shape " + shape_text(shape) + " of " + std::to_string(8 * bytes)
        + " bit numbers, but has only " + std::to_string(there)
        + " bytes: it was never written completely, or the file is damaged";
    return std::string();
  }

  // reads some rows of a data set by `read(memory space, file space)`
  template <class Read>
  static bool read_slab(hid_t dataset, const std::vector<std::uint64_t>& shape, std::uint64_t first,
                        std::uint64_t count, const Read& read)
  {
    const Hdf5_handle space(H5Dget_space(dataset), &H5Sclose);
    std::vector<hsize_t> begin(shape.size(), 0), size(shape.begin(), shape.end());
    begin[0] = first;
    size[0] = count;
    const Hdf5_handle memory(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), &H5Sclose);
    return space.is_valid() && memory.is_valid()
      && H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr) >= 0
      && read(memory.get(), space.get()) >= 0;
  }

  static std::string failed_at(std::uint64_t row)
  {
    return "cannot be read from row " + std::to_string(row) + " on (" + reason_of_library()
      + "): the file is truncated or damaged; get a complete copy of it";
  }

  // `shape` is that of the data set, if it differs from that of the array
  static std::string read_all_rows(hid_t dataset, hid_t type, Number_array& array, std::uint64_t count,
                                   const std::vector<std::uint64_t>* shape = nullptr)
  {
    if (array.shape.empty() || count == 0)
      return array.shape.empty() ? "is a single number, not an array" : std::string();
    const std::uint64_t row = count / array.shape[0];
    const std::uint64_t rows = (std::max)(std::uint64_t(1), values_per_slab / row);
    for (std::uint64_t first = 0; first < array.shape[0]; first += rows)
    {
      const std::uint64_t step = (std::min)(rows, array.shape[0] - first);
      const std::size_t done = array.values.size();
      array.values.resize(done + static_cast<std::size_t>(step * row));
      double* const target = array.values.data() + done;
      if (!read_slab(dataset, shape != nullptr ? *shape : array.shape, first, step, [&](hid_t memory, hid_t space) {
            return H5Dread(dataset, type, memory, space, H5P_DEFAULT, target);
          }))
        return failed_at(first);
    }
    return std::string();
  }

  // rows of different lengths, as whole models have them
  std::string read_ragged(hid_t dataset, hid_t file_type, Number_array& array)
  {
    array.is_ragged = true;
    const Hdf5_handle type(H5Tvlen_create(H5T_NATIVE_DOUBLE), &H5Tclose);
    const std::uint64_t there = stored_size(dataset);
    if (array.shape[0] > 0 && array.shape[0] > there * largest_compression / H5Tget_size(file_type))
      return "promises " + std::to_string(array.shape[0]) + " rows, but has only " + std::to_string(there)
        + " bytes for them: it was never written completely, or the file is damaged";
    for (std::uint64_t first = 0; first < array.shape[0]; first += rows_per_slab)
    {
      const std::uint64_t step = (std::min)(rows_per_slab, array.shape[0] - first);
      std::vector<hvl_t> rows(static_cast<std::size_t>(step), hvl_t{0, nullptr});
      const bool is_read = read_slab(dataset, array.shape, first, step, [&](hid_t memory, hid_t space) {
        const herr_t status = H5Dread(dataset, type.get(), memory, space, H5P_DEFAULT, rows.data());
        if (status >= 0)
          for (const hvl_t& row : rows)
          {
            const double* const values = static_cast<const double*>(row.p);
            array.values.insert(array.values.end(), values, values + row.len);
            array.row_sizes.push_back(row.len);
          }
        H5Dvlen_reclaim(type.get(), memory, H5P_DEFAULT, rows.data());
        return status;
      });
      if (!is_read)
        return failed_at(first);
    }
    return std::string();
  }

  Hdf5_silence m_silence;
  std::string m_filename;
  Hdf5_handle m_file;
  std::size_t m_number_of_visited = 0;
  std::vector<std::string> m_names;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_HDF5_FILE_H
