// The files that the tool extract_wireframe writes: looked at before the work, written after it.

#ifndef EXTRACT_WIREFRAME_OUTPUT_FILES_H
#define EXTRACT_WIREFRAME_OUTPUT_FILES_H

#include "Error.h"
#include "Options.h"
#include "Stage_folder.h"
#include "write_in_format.h"
#include "write_page.h"
#include "write_picture.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/write_beside_and_rename.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace tool {

// what is written beside the wireframe: the name of a file, and what writes it
struct Picture
{
  std::string name;
  std::function<bool(std::ostream&, std::string&)> write;
};

template <class GeomTraits>
class Output_files
{
  typedef CGAL::Wireframe<GeomTraits> Wireframe;

public:
  explicit Output_files(const Options& options) : m_options(options), m_names(options.outputs) {}

  // throws what would make writing fail, before any work is done
  void check() const
  {
    for (const std::string& name : m_names)
    {
      if (name.empty())
        throw Error(USAGE_ERROR, "the name of an output file is empty");
      check_extension(name, extension_of(name));
      if (name != "-")
        check_writable(name);
    }
    if (m_options.has_html)
      check_page();
    if (m_options.has_png)
      check_picture();
    if (m_options.has_field)
      check_field();
    if (m_options.has_shared_features)
      check_shared_features();
  }

  static void check_extension(const std::string& name, const std::string& extension)
  {
    if (!has_format(extension))
      throw Error(USAGE_ERROR, name + ": " + why_unknown(extension));
  }

  // Each file is written as a whole or not at all. One that cannot be written stops no other one: returns the names of
  // those that are written, and what is wrong with the others.
  std::vector<std::string> write(const Wireframe& wireframe, const CGAL::Wireframe_provenance& provenance,
                                 const std::vector<Picture>& pictures, std::string& problems) const
  {
    std::vector<Picture> files;
    for (const std::string& name : m_names)
      files.push_back({name, [this, &name, &wireframe, &provenance](std::ostream& stream, std::string& error) {
                         return write_in_format(extension_of(name), stream, wireframe, m_options, provenance, error);
                       }});
    files.insert(files.end(), pictures.begin(), pictures.end());
    std::vector<std::string> written;
    for (const Picture& file : files)
    {
      std::string error;
      if (file.name == "-" ? write_to_standard_output(file, error) : write(file, error))
        written.push_back(file.name);
      else
        problems += (problems.empty() ? "" : "; ") + error;
    }
    return written;
  }

private:
  static std::string why_unknown(const std::string& extension)
  {
    if (CGAL::IO::internal::is_cad_extension(extension))
      return "this extract_wireframe was built without OpenCASCADE, which " + extension
        + " needs; install it (Debian: libocct-data-exchange-dev) and build again";
    if (extension == ".html" || extension == ".png")
      return "it shows the cloud, too; write it with --" + extension.substr(1) + " OUT" + extension;
    return std::string("unknown extension of a wireframe; known are ")
      + CGAL::IO::internal::known_wireframe_extensions();
  }

  void check_page() const
  {
    if (m_options.html.empty())
      throw Error(USAGE_ERROR, "the name of the page is empty; give --html OUT.html");
    const std::string extension = CGAL::IO::internal::lower_extension(m_options.html);
    if (extension != ".html" && extension != ".htm")
      throw Error(USAGE_ERROR, m_options.html + ": a page is written into .html; give --html OUT.html");
    if (!has_viewer())
      throw Error(USAGE_ERROR,
                  m_options.html
                    + ": this extract_wireframe was built without the viewer that --html "
                      "needs; install three.js and esbuild (Debian: libjs-three esbuild), configure and build again");
    check_writable(m_options.html);
  }

  void check_picture() const
  {
    if (m_options.png.empty())
      throw Error(USAGE_ERROR, "the name of the picture is empty; give --png OUT.png");
    if (CGAL::IO::internal::lower_extension(m_options.png) != ".png")
      throw Error(USAGE_ERROR, m_options.png + ": a picture is written into .png; give --png OUT.png");
    if (!has_png())
      throw Error(USAGE_ERROR,
                  m_options.png
                    + ": this extract_wireframe was built without libpng, which --png needs; "
                      "install it (Debian: libpng-dev) and build again");
    check_writable(m_options.png);
  }

  void check_field() const
  {
    if (CGAL::IO::internal::lower_extension(m_options.field) != ".ply")
      throw Error(USAGE_ERROR, m_options.field + ": a field is written into .ply; give --write-field OUT.ply");
    check_writable(m_options.field);
  }

  void check_shared_features() const
  {
    if (CGAL::IO::internal::lower_extension(m_options.shared_features) != ".csv")
      throw Error(USAGE_ERROR, m_options.shared_features + ": it is a table in .csv; give --shared-features OUT.csv");
    check_writable(m_options.shared_features);
  }

  static void check_writable(const std::string& name)
  {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::file_status status = fs::status(name, code);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
      return; // looking at a device or pipe would already do something to it
    const fs::path folder = fs::absolute(name, code).parent_path();
    if (!fs::is_directory(folder, code))
      throw Error(USAGE_ERROR, name + ": cannot be written, there is no folder " + folder.string() + "; make it first");
    // a writer that gives up leaves everything as it was
    std::string error;
    bool is_writable = false;
    CGAL::IO::internal::write_beside_and_rename(
      name,
      [&is_writable](std::ostream&, std::string& reason) {
        is_writable = true;
        reason = "only a trial";
        return false;
      },
      error);
    if (!is_writable)
      throw Error(USAGE_ERROR, error);
  }

  // the extension that stands for the format of an output
  std::string extension_of(const std::string& name) const
  {
    return name == "-" ? "." + CGAL::IO::internal::to_lower(m_options.output_format)
                       : CGAL::IO::internal::lower_extension(name);
  }

  static bool write(const Picture& file, std::string& error)
  {
    return CGAL::IO::internal::write_beside_and_rename(
      file.name,
      [&file](std::ostream& stream, std::string& reason) {
        const bool is_written = file.write(stream, reason);
        if (!is_written && !stream)
          reason.clear(); // the system knows better why the stream takes nothing
        return is_written;
      },
      error);
  }

  // as a whole or not at all, here as well
  static bool write_to_standard_output(const Picture& file, std::string& error)
  {
    std::ostringstream text;
    if (!file.write(text, error))
      return false;
    if (!(std::cout << text.str() << std::flush))
      error = "the standard output: cannot be written completely";
    return static_cast<bool>(std::cout);
  }

  const Options& m_options;
  const std::vector<std::string>& m_names;
};

// No file may be written over another one of this run, least of all over the cloud.
inline void check_that_files_differ(const Options& options)
{
  namespace fs = std::filesystem;
  std::map<fs::path, std::string> names;
  const auto add = [&names](const std::string& name, bool is_written) {
    std::error_code code;
    const fs::path path = fs::weakly_canonical(fs::absolute(name, code), code);
    const bool is_device = fs::exists(path, code) && !fs::is_regular_file(path, code);
    if (!names.emplace(path, name).second && is_written && !is_device)
      throw Error(USAGE_ERROR,
                  name + ": is to be written, but " + names[path] + " is the same file; give different names");
  };
  for (const std::string& name : options.input.files)
    add(name, false);
  if (options.input.has_distances)
    add(options.input.distances, false);
  for (const std::string& name : options.outputs)
    add(name, true);
  if (options.has_html)
    add(options.html, true);
  if (options.has_png)
    add(options.png, true);
  if (options.has_field)
    add(options.field, true);
  if (options.has_shared_features)
    add(options.shared_features, true);
  if (options.has_stages)
    for (const std::string& name : Stage_folder::file_names())
      add((fs::path(options.stages_folder) / name).string(), true);
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_OUTPUT_FILES_H
