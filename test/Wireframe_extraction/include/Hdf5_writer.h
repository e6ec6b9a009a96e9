// Writes HDF5 files, if there is the library.

#ifndef HDF5_WRITER_H
#define HDF5_WRITER_H

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5

#include "lzf.h"

#include <hdf5.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string>
#include <vector>

class Hdf5_writer
{
public:
  explicit Hdf5_writer(const std::string& name)
    : m_file(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT))
  {
    assert(m_file >= 0);
  }

  ~Hdf5_writer() { H5Fclose(m_file); }

  void add_group(const std::string& name)
  {
    H5Gclose(H5Gcreate2(m_file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }

  void add(const std::string& name, const std::vector<double>& values, const std::vector<hsize_t>& shape,
           hid_t type = H5T_IEEE_F64LE, bool is_compressed = false, bool is_written = true)
  {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    if (is_compressed)
    {
      std::vector<hsize_t> chunk(shape);
      chunk[0] = (std::min)(chunk[0], hsize_t(100));
      H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
      H5Pset_deflate(properties, 9);
    }
    const hid_t dataset = H5Dcreate2(m_file, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    assert(dataset >= 0);
    if (is_written)
      assert(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    H5Dclose(dataset);
    H5Pclose(properties);
    H5Sclose(space);
  }

  // Compressed as h5py does it with `lzf`, in chunks of one row each; `damage` may change what is stored of a chunk.
  template <class Damage>
  void add_lzf(const std::string& name, const std::vector<double>& values, const std::vector<hsize_t>& shape,
               const Damage& damage)
  {
    std::vector<hsize_t> chunk(shape), place(shape.size(), 0);
    chunk[0] = 1;
    const std::size_t size = sizeof(double) * values.size() / shape[0];
    add_filtered(name, shape, chunk, 32000, {4, 0x0105, static_cast<unsigned int>(size)});
    const hid_t dataset = H5Dopen2(m_file, name.c_str(), H5P_DEFAULT);
    for (; place[0] < shape[0]; ++place[0])
    {
      std::vector<unsigned char> stored =
        lzf(reinterpret_cast<const unsigned char*>(values.data()) + place[0] * size, size);
      damage(stored);
      assert(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, place.data(), stored.size(), stored.data()) >= 0);
    }
    H5Dclose(dataset);
  }

  // a data set by a filter that need not be there
  void add_filtered(const std::string& name, const std::vector<hsize_t>& shape, const std::vector<hsize_t>& chunk,
                    H5Z_filter_t filter, const std::vector<unsigned int>& parameters)
  {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
    H5Pset_filter(properties, filter, H5Z_FLAG_OPTIONAL, parameters.size(), parameters.data());
    const hid_t dataset =
      H5Dcreate2(m_file, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    assert(dataset >= 0);
    H5Dclose(dataset);
    H5Pclose(properties);
    H5Sclose(space);
  }

  void add_rows(const std::string& name, std::vector<std::vector<double>> rows, hid_t type = H5T_IEEE_F64LE)
  {
    const hsize_t count = rows.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t file_type = H5Tvlen_create(type), memory_type = H5Tvlen_create(H5T_NATIVE_DOUBLE);
    const hid_t dataset = H5Dcreate2(m_file, name.c_str(), file_type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    std::vector<hvl_t> raw;
    for (std::vector<double>& row : rows)
      raw.push_back({row.size(), row.data()});
    assert(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) >= 0);
    H5Dclose(dataset);
    H5Tclose(memory_type);
    H5Tclose(file_type);
    H5Sclose(space);
  }

  void add_external(const std::string& name, hsize_t count)
  {
    const hsize_t shape[] = {count, 3};
    const hid_t space = H5Screate_simple(2, shape, nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(properties, "scratch_elsewhere.raw", 0, H5F_UNLIMITED);
    H5Dclose(H5Dcreate2(m_file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties);
    H5Sclose(space);
  }

  void add_text(const std::string& name)
  {
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t dataset = H5Dcreate2(m_file, name.c_str(), H5T_C_S1, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dclose(dataset);
    H5Sclose(space);
  }

private:
  hid_t m_file;
};

#endif

#endif // HDF5_WRITER_H
