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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NPY_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NPY_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Array_file.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <CGAL/config.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Where bytes come from: a file, or a part of an archive.
class Byte_source
{
public:
  virtual ~Byte_source() {}

  // returns how many bytes were there, fewer only at the end
  virtual std::size_t read(char* target, std::size_t size) = 0;
  // no more bytes than this can still come
  virtual std::uint64_t largest_rest() const = 0;
  // why there are no more, if it is not the end
  virtual const std::string& error() const = 0;
};

class File_bytes : public Byte_source
{
public:
  explicit File_bytes(std::istream& stream) : m_stream(stream), m_rest((std::numeric_limits<std::uint64_t>::max)())
  {
    const std::istream::pos_type begin = m_stream.tellg();
    if (begin != std::istream::pos_type(-1) && m_stream.seekg(0, std::ios::end))
    {
      const std::istream::pos_type end = m_stream.tellg();
      m_stream.seekg(begin);
      if (end > begin) // special files say zero and may still deliver
        m_rest = static_cast<std::uint64_t>(end - begin);
    }
    m_stream.clear();
  }

  std::size_t read(char* target, std::size_t size) override
  {
    m_stream.read(target, static_cast<std::streamsize>(size));
    if (m_stream.bad())
      m_error = "reading failed";
    const std::size_t count = static_cast<std::size_t>(m_stream.gcount());
    m_rest -= (std::min)(m_rest, std::uint64_t(count));
    return count;
  }

  std::uint64_t largest_rest() const override { return m_rest; }
  const std::string& error() const override { return m_error; }

private:
  std::istream& m_stream;
  std::uint64_t m_rest;
  std::string m_error;
};

// Numbers of one type among the bytes of an entry.
struct Npy_field
{
  std::string name;
  char kind = 'f';
  std::size_t size = 0, offset = 0;
  bool is_swapped = false;

  // whether it is a number that can be read
  bool is_number() const { return is_number_type(kind, size); }
};

// The header of a .npy file: a Python dictionary with exactly three entries.
class Npy_header
{
public:
  std::vector<Npy_field> fields; // what is read of an entry: a single number, or the fields of a structure
  std::size_t entry_size = 0;
  bool is_structured = false, is_fortran_order = false;
  std::vector<std::uint64_t> shape;

  // returns what is wrong with it, nothing if all is well
  std::string parse(std::string_view text)
  {
    m_text = text;
    bool has_type = false, has_order = false, has_shape = false;
    if (!accept('{'))
      return malformed();
    while (!accept('}'))
    {
      std::string key;
      if (!accept_string(key) || !accept(':'))
        return malformed();
      bool& is_there = key == "descr" ? has_type : key == "fortran_order" ? has_order : has_shape;
      if (is_there || (key != "descr" && key != "fortran_order" && key != "shape"))
        return "its header has an unexpected entry " + quote(key);
      is_there = true;
      const std::string error = key == "descr" ? parse_type() : key == "shape" ? parse_shape() : parse_order();
      if (!error.empty())
        return error;
      if (!accept(',') && next() != '}')
        return malformed();
    }
    if (next() != '\0')
      return malformed();
    return has_type && has_order && has_shape ? std::string() : "its header lacks descr, fortran_order or shape";
  }

private:
  static std::string malformed()
  {
    return "its header is malformed: the file is damaged, or no NumPy file; write it with numpy.save()";
  }

  char next()
  {
    while (!m_text.empty() && (is_blank(m_text.front()) || m_text.front() == '\n'))
      m_text.remove_prefix(1);
    return m_text.empty() ? '\0' : m_text.front();
  }

  bool accept(char c)
  {
    if (next() != c)
      return false;
    m_text.remove_prefix(1);
    return true;
  }

  bool accept_string(std::string& value)
  {
    const char mark = next();
    if (mark != '\'' && mark != '"')
      return false;
    const std::size_t end = m_text.find(mark, 1);
    if (end == std::string_view::npos)
      return false;
    value = std::string(m_text.substr(1, end - 1));
    m_text.remove_prefix(end + 1);
    return true;
  }

  static std::string remedy()
  {
    return "; numbers of up to 64 bits are read: convert it with numpy.asarray(array, dtype=float)";
  }

  std::string parse_type()
  {
    if (next() == '[')
      return parse_structure();
    std::string type;
    if (!accept_string(type))
      return malformed();
    if (type.size() > 1 && type[1] == 'O')
      return "is an array of Python objects, which only Python can read" + remedy();
    Npy_field field;
    if (!parse_type_of(type, field) || !field.is_number())
      return "has numbers of the type " + quote(type) + remedy();
    fields = {field};
    entry_size = field.size;
    return std::string();
  }

  // Gets the type of a number, or of something else that has a size, as numpy writes it, such as <f8.
  static bool parse_type_of(const std::string& type, Npy_field& field)
  {
    const char order = type.empty() ? '\0' : type[0];
    std::size_t size = 0;
    if (type.size() < 3 || (order != '<' && order != '>' && order != '|' && order != '=')
        || !parse_count(std::string_view(type).substr(2), size) || size > largest_entry)
      return false;
    field.kind = type[1];
    if (is_number_type(field.kind, size) && order == '|' && size != 1)
      return false;
    constexpr std::size_t size_of_letter = 4; // of texts, whose size is counted in letters
    field.size = field.kind == 'U' ? size_of_letter * size : size;
    field.is_swapped = (order == '<' && !is_host_little_endian()) || (order == '>' && is_host_little_endian());
    return std::string_view("fiubcSUVmM").find(field.kind) != std::string_view::npos;
  }

  // [('x', '<f8'), ('normal', '<f4', (3,)), ...]: what is no number is passed over, and where a field has several, each
  // is one that is called normal:0 and so on
  std::string parse_structure()
  {
    is_structured = true;
    accept('[');
    while (!accept(']'))
    {
      Npy_field field;
      std::string type;
      std::uint64_t count = 1;
      if (!accept('(') || !accept_string(field.name) || !accept(','))
        return malformed();
      if (next() == '[')
        return "is a structured array within which there are others" + remedy();
      if (!accept_string(type))
        return malformed();
      if (!parse_type_of(type, field))
        return "has a field " + quote(field.name) + " of the type " + quote(type) + remedy();
      if (accept(',') && next() == '(')
      {
        std::vector<std::uint64_t> sizes;
        if (!parse_sizes(sizes) || !find_number(sizes, count))
          return malformed();
      }
      if (!accept(')') || (!accept(',') && next() != ']'))
        return malformed();
      if (!add_field(field, count))
        return "has entries that are too large" + remedy();
    }
    return fields.empty() ? "is a structured array without numbers" + remedy() : std::string();
  }

  static bool find_number(const std::vector<std::uint64_t>& sizes, std::uint64_t& count)
  {
    for (const std::uint64_t size : sizes)
      if ((count *= (std::min)(size, std::uint64_t(largest_entry) + 1)) > largest_entry)
        return false;
    return true;
  }

  bool add_field(Npy_field field, std::uint64_t count)
  {
    if (field.size * count > largest_entry - entry_size)
      return false;
    const std::string name = field.name;
    for (std::uint64_t i = 0; i < count && field.is_number(); ++i)
    {
      field.name = count == 1 ? name : name + ":" + std::to_string(i);
      field.offset = entry_size + static_cast<std::size_t>(i) * field.size;
      fields.push_back(field);
    }
    entry_size += static_cast<std::size_t>(count) * field.size;
    return true;
  }

  std::string parse_order()
  {
    next();
    for (const char* const word : {"True", "False"})
      if (starts_with(m_text, word))
      {
        is_fortran_order = (word[0] == 'T');
        m_text.remove_prefix(std::string_view(word).size());
        return std::string();
      }
    return malformed();
  }

  std::string parse_shape() { return parse_sizes(shape) ? std::string() : malformed(); }

  bool parse_sizes(std::vector<std::uint64_t>& sizes)
  {
    if (!accept('('))
      return false;
    while (!accept(')'))
    {
      next();
      const std::size_t end = (std::min)(m_text.find_first_not_of("0123456789"), m_text.size());
      std::uint64_t count = 0;
      if (!parse_count(m_text.substr(0, end), count) || sizes.size() == 32)
        return false;
      sizes.push_back(count);
      m_text.remove_prefix(end);
      if (!accept(',') && next() != ')')
        return false;
    }
    return true;
  }

  static constexpr std::size_t largest_entry = std::size_t(1) << 16; // bytes

  std::string_view m_text;
};

// Reads what numpy.save() writes. Memory goes to what is there, not to what the header promises.
class Npy_reader
{
public:
  Npy_reader(Byte_source& source, const std::string& name) : m_source(source), m_name(name) {}

  bool read(Number_array& array)
  {
    Npy_header header;
    std::uint64_t count = 0;
    if (!read_header(header))
      return false;
    if (!find_number_of_values(header.shape, count) || count > m_source.largest_rest() / header.entry_size)
      return fail("its header promises the shape " + shape_text(header.shape) + " of "
                  + std::to_string(8 * header.entry_size) + " bit " + (header.is_structured ? "entries" : "numbers")
                  + ", but it has at most " + std::to_string(m_source.largest_rest())
                  + " bytes after the header: it is truncated or its header "
                    "is wrong; get a complete copy of the file");
    array.shape = header.shape;
    if (!read_values(header, count, array.values))
      return false;
    if (header.is_structured)
      name_columns(header, array);
    char byte;
    if (m_source.read(&byte, 1) != 0)
      return fail("holds more than the shape " + shape_text(header.shape) + " that its header promises");
    if (!m_source.error().empty())
      return fail(m_source.error());
    if (header.is_fortran_order && !header.is_structured)
      reorder(array);
    return true;
  }

  const std::string& error() const { return m_error; }

private:
  bool fail(const std::string& what)
  {
    m_error = m_name + ": " + what;
    return false;
  }

  bool fail_truncated(const std::string& where)
  {
    return fail(!m_source.error().empty() ? m_source.error()
                                          : "is truncated: it ends " + where + "; get a complete copy of the file");
  }

  bool read_header(Npy_header& header)
  {
    char start[12];
    const std::size_t size = m_source.read(start, 8);
    if (size == 0)
      return m_source.error().empty() ? fail(empty_file_text()) : fail(m_source.error());
    if (std::string_view(start, (std::min)(size, std::size_t(6))) != std::string_view("\x93NUMPY", 6))
      return fail("is no NumPy file: it starts with " + quote(std::string_view(start, size))
                  + "; numpy.save() writes one");
    if (size < 8)
      return fail_truncated("in its header");
    const int version = static_cast<unsigned char>(start[6]);
    if (version < 1 || version > 3)
      return fail("has version " + std::to_string(version) + " of the format; versions 1 to 3 are known");
    const std::size_t number_of_length_bytes = (version == 1) ? 2 : 4;
    if (m_source.read(start + 8, number_of_length_bytes) < number_of_length_bytes)
      return fail_truncated("in its header");
    const std::size_t length =
      (version == 1) ? load_little_endian<std::uint16_t>(start + 8) : load_little_endian<std::uint32_t>(start + 8);
    if (length > largest_header)
      return fail("its header is " + std::to_string(length) + " bytes long, which no header of an array of numbers is");
    std::string text(length, '\0');
    if (m_source.read(&text[0], length) < length)
      return fail_truncated("in its header");
    const std::string error = header.parse(text);
    return error.empty() || fail(error);
  }

  bool read_values(const Npy_header& header, std::uint64_t count, std::vector<double>& values)
  {
    static constexpr std::size_t bytes_per_chunk = std::size_t(1) << 16;
    const std::size_t size = header.entry_size;
    const std::uint64_t entries_per_chunk = (std::max)(std::size_t(1), bytes_per_chunk / size);
    std::vector<char> bytes(static_cast<std::size_t>(entries_per_chunk) * size);
    for (std::uint64_t done = 0; done < count;)
    {
      const std::size_t wanted = static_cast<std::size_t>((std::min)(count - done, entries_per_chunk));
      const std::size_t there = m_source.read(bytes.data(), wanted * size) / size;
      for (std::size_t i = 0; i < there; ++i)
        for (const Npy_field& field : header.fields)
          values.push_back(
            load_number(field.kind, field.size, bytes.data() + i * size + field.offset, field.is_swapped));
      done += there;
      if (there < wanted)
        return fail_truncated("after " + std::to_string(done) + " of " + std::to_string(count)
                              + (header.is_structured ? " entries" : " numbers"));
    }
    return true;
  }

  // A structure is a row of its numbers. How the structures are arranged does not matter.
  static void name_columns(const Npy_header& header, Number_array& array)
  {
    for (const Npy_field& field : header.fields)
      array.columns.push_back(field.name);
    array.shape = {array.values.size() / header.fields.size(), header.fields.size()};
  }

  // In Fortran's order the first index runs fastest, in ours the last one.
  static void reorder(Number_array& array)
  {
    std::vector<double> ordered;
    ordered.reserve(array.values.size());
    std::vector<std::size_t> position(array.shape.size(), 0);
    while (ordered.size() < array.values.size())
    {
      std::size_t index = 0;
      for (std::size_t i = position.size(); i-- > 0;)
        index = index * static_cast<std::size_t>(array.shape[i]) + position[i];
      ordered.push_back(array.values[index]);
      for (std::size_t i = position.size(); i-- > 0 && ++position[i] == array.shape[i];)
        position[i] = 0;
    }
    array.values.swap(ordered);
  }

  static constexpr std::size_t largest_header = std::size_t(1) << 20;

  Byte_source& m_source;
  std::string m_name;
  std::string m_error;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NPY_READER_H
