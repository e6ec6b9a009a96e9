// The list of clouds of a batch, and the names of what is made of them.

#ifndef EXTRACT_WIREFRAME_BATCH_LIST_H
#define EXTRACT_WIREFRAME_BATCH_LIST_H

#include "Error.h"
#include "run_batch.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tool {

// The names of the clouds, in the order of the list. There may be millions, so that only the text and places in it are
// kept.
class Batch_list
{
public:
  explicit Batch_list(const Batch_options& options)
    : m_name(options.list == "-" ? "standard input" : options.list), m_text(read(options.list))
  {
    namespace fs = std::filesystem;
    m_folder = options.input_folder.empty() && options.list != "-" ? fs::path(options.list).parent_path()
                                                                   : fs::path(options.input_folder);
    std::error_code code;
    if (!m_folder.empty() && !fs::is_directory(m_folder, code))
      throw Error(USAGE_ERROR, m_folder.string() + ": is not a folder; --input-dir says where relative names start");
    m_absolute_folder = fs::absolute(m_folder.empty() ? fs::path(".") : m_folder).lexically_normal();
    if (!m_absolute_folder.has_filename())
      m_absolute_folder = m_absolute_folder.parent_path(); // without the slash at its end
    find_lines();
    check_names();
  }

  const std::string& name() const { return m_name; }
  const std::string& text() const { return m_text; }
  std::string folder() const { return m_absolute_folder.string(); } // of clouds with relative names
  std::size_t size() const { return m_lines.size(); }

  // as it stands in the list
  std::string entry(std::size_t i) const { return m_text.substr(m_lines[i].begin, m_lines[i].size); }

  // where the cloud is
  std::string cloud(std::size_t i) const { return (m_folder / entry(i)).string(); }

  // The name of the outputs, without extension, relative to the folder of outputs: the path of the cloud from the
  // folder of inputs, or from the root if it is elsewhere. So it does not depend on what else is in the list.
  std::string output_name(std::size_t i) const
  {
    namespace fs = std::filesystem;
    const fs::path path = (m_absolute_folder / entry(i)).lexically_normal();
    fs::path name = path.lexically_relative(m_absolute_folder);
    if (name.empty() || *name.begin() == "..")
      name = path.relative_path();
    return name.replace_extension().generic_string();
  }

  // "LIST:LINE", for messages
  std::string place(std::size_t i) const { return m_name + ":" + std::to_string(m_lines[i].number); }

private:
  struct Line
  {
    std::size_t begin, size, number;
  };

  static std::string read(const std::string& name)
  {
    if (name == "-")
      return std::string(std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>());
    std::ifstream stream;
    std::string error;
    if (!CGAL::IO::internal::open_input_file(name, stream, error))
      throw Error(BAD_INPUT, error);
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }

  void find_lines()
  {
    if (m_text.compare(0, 3, "\xEF\xBB\xBF") == 0) // some editors start a text so
      m_text.erase(0, 3);
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < m_text.size();)
    {
      const std::size_t end = (std::min)(m_text.find('\n', begin), m_text.size());
      add_line(begin, end, ++number);
      begin = end + 1;
    }
    if (m_lines.empty())
      throw Error(BAD_INPUT, m_name + ": names no cloud; write one per line");
  }

  void add_line(std::size_t begin, std::size_t end, std::size_t number)
  {
    const char* const blanks = " \t\r";
    begin = (std::min)(m_text.find_first_not_of(blanks, begin), end);
    if (begin == end || m_text[begin] == '#')
      return;
    const std::size_t size = m_text.find_last_not_of(blanks, end - 1) + 1 - begin;
    if (std::string_view(m_text).substr(begin, size).find('\0') != std::string_view::npos)
      throw Error(BAD_INPUT,
                  m_name + ":" + std::to_string(number)
                    + ": has a zero byte; a list is a text with the name of one cloud per line");
    m_lines.push_back(Line{begin, size, number});
  }

  // What two clouds would both write, one of them would lose.
  void check_names() const
  {
    std::vector<std::pair<std::size_t, std::size_t>> hashes;
    hashes.reserve(size());
    for (std::size_t i = 0; i < size(); ++i)
    {
      const std::string name = output_name(i);
      const std::size_t slash = name.rfind('/');
      if (name.empty() || slash + 1 == name.size())
        throw Error(BAD_INPUT, place(i) + ": " + entry(i) + " is the name of a folder, not of a cloud");
      hashes.emplace_back(std::hash<std::string>()(name), i);
    }
    std::sort(hashes.begin(), hashes.end());
    for (std::size_t k = 1; k < hashes.size(); ++k)
      for (std::size_t other = k; other-- > 0 && hashes[other].first == hashes[k].first;)
        check_differ(hashes[other].second, hashes[k].second);
  }

  void check_differ(std::size_t i, std::size_t j) const
  {
    if (output_name(i) != output_name(j))
      return;
    if (entry(i) == entry(j))
      throw Error(BAD_INPUT,
                  place(j) + ": " + entry(j) + " stands already in line " + std::to_string(m_lines[i].number)
                    + "; remove one of the two");
    throw Error(BAD_INPUT,
                place(j) + ": " + entry(j) + " and " + entry(i) + " of line " + std::to_string(m_lines[i].number)
                  + " would both be written to " + output_name(j)
                  + ".*; rename one, or put it into a list with another --output-dir");
  }

  std::string m_name, m_text;
  std::filesystem::path m_folder, m_absolute_folder;
  std::vector<Line> m_lines;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_LIST_H
