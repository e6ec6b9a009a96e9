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

#ifndef CASE_MAKER_READ_ABC_FEATURES_H
#define CASE_MAKER_READ_ABC_FEATURES_H

#include <Case_maker/Case_error.h>
#include <Case_maker/read_obj_mesh.h>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace Case_maker {

/// A curve of the ABC dataset.
struct Abc_curve
{
  std::size_t line = 0; ///< of the file
  std::string type;
  bool is_sharp = false;
  bool has_sharp = false;
  std::vector<std::uint32_t> vertices; ///< of the mesh, in their order along the curve
};

/// A surface of the ABC dataset.
struct Abc_surface
{
  std::size_t line = 0; ///< of the file
  std::string type;
  std::vector<std::uint32_t> faces; ///< of the mesh
};

struct Abc_features
{
  std::vector<Abc_curve> curves;
  std::vector<Abc_surface> surfaces;
};

namespace internal {

/// Takes from a stream of YAML what is needed here. A feature file may have a hundred megabytes, most of them
/// parameters: these are not kept.
class Abc_feature_handler : public YAML::EventHandler
{
public:
  Abc_feature_handler(const std::string& path, Abc_features& features) : m_path(path), m_features(features) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { value(mark, ""); }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override
  {
    throw bad_input(m_path, line_of(mark), "YAML aliases are not understood here; write the value itself");
  }

  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string& text) override
  {
    if (!m_frames.empty() && m_frames.back().is_map && !m_frames.back().has_key)
    {
      m_frames.back().key = text;
      m_frames.back().has_key = true;
    }
    else
      value(mark, text);
  }

  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override
  {
    m_frames.push_back(Frame{false, false, ""});
  }

  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override
  {
    m_frames.push_back(Frame{true, false, ""});
    if (m_frames.size() != 3 || !m_frames[0].is_map || m_frames[1].is_map)
      return;
    if (m_frames[0].key == "curves")
    {
      m_features.curves.emplace_back();
      m_features.curves.back().line = line_of(mark);
    }
    else if (m_frames[0].key == "surfaces")
    {
      m_features.surfaces.emplace_back();
      m_features.surfaces.back().line = line_of(mark);
    }
  }

  void OnMapEnd() override { close(); }

private:
  struct Frame
  {
    bool is_map;
    bool has_key;
    std::string key;
  };

  static std::size_t line_of(const YAML::Mark& mark) { return static_cast<std::size_t>(mark.line) + 1; }

  void close()
  {
    m_frames.pop_back();
    if (!m_frames.empty() && m_frames.back().is_map)
      m_frames.back().has_key = false;
  }

  /// a scalar that is no key
  void value(const YAML::Mark& mark, const std::string& text)
  {
    const bool is_of_list = m_frames.size() == 4 && !m_frames[3].is_map;
    if ((m_frames.size() == 3 || is_of_list) && m_frames[0].is_map && !m_frames[1].is_map && m_frames[2].is_map)
    {
      const std::string& name = m_frames[2].key;
      if (m_frames[0].key == "curves" && !m_features.curves.empty())
        set(m_features.curves.back(), name, is_of_list, mark, text);
      else if (m_frames[0].key == "surfaces" && !m_features.surfaces.empty())
        set(m_features.surfaces.back(), name, is_of_list, mark, text);
    }
    if (!m_frames.empty() && m_frames.back().is_map)
      m_frames.back().has_key = false;
  }

  void set(Abc_curve& curve, const std::string& name, bool is_of_list, const YAML::Mark& mark, const std::string& text)
  {
    if (name == "vert_indices")
      curve.vertices.push_back(index(name, is_of_list, mark, text));
    else if (name == "type" && !is_of_list)
      curve.type = text;
    else if (name == "sharp")
    {
      if (is_of_list || (text != "true" && text != "false"))
        throw bad_input(m_path, line_of(mark), "'sharp' is true or false, not '" + text + "'");
      curve.is_sharp = text == "true";
      curve.has_sharp = true;
    }
  }

  void set(Abc_surface& surface, const std::string& name, bool is_of_list, const YAML::Mark& mark,
           const std::string& text)
  {
    if (name == "face_indices")
      surface.faces.push_back(index(name, is_of_list, mark, text));
    else if (name == "type" && !is_of_list)
      surface.type = text;
  }

  std::uint32_t index(const std::string& name, bool is_of_list, const YAML::Mark& mark, const std::string& text) const
  {
    const bool is_whole =
      !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string::npos;
    if (!is_of_list || !is_whole)
      throw bad_input(m_path, line_of(mark),
                      "'" + name + "' is a list of whole numbers, counted from 0, not '" + text + "'");
    return static_cast<std::uint32_t>(std::stoul(text));
  }

  std::string m_path;
  Abc_features& m_features;
  std::vector<Frame> m_frames;
};

} // namespace internal

/// reads the curves and surfaces from a feature file of the ABC dataset (YAML).
inline Abc_features read_abc_features(const std::string& path)
{
  std::istringstream in(read_file(path));
  Abc_features result;
  try
  {
    YAML::Parser parser(in);
    internal::Abc_feature_handler handler(path, result);
    parser.HandleNextDocument(handler);
  }
  catch (const YAML::Exception& error)
  {
    throw bad_input(path, static_cast<std::size_t>(error.mark.line + 1),
                    "this is not YAML: " + error.msg + "; is the file complete?");
  }
  if (result.surfaces.empty())
    throw bad_input("'" + path
                    + "' has no list 'surfaces' of maps; is it a feature file of the ABC "
                      "dataset?");
  for (std::size_t i = 0; i < result.curves.size(); ++i)
    if (!result.curves[i].has_sharp)
      throw bad_input(path, result.curves[i].line,
                      "curve " + std::to_string(i) + " does not say whether it is 'sharp'");
  return result;
}

} // namespace Case_maker

#endif // CASE_MAKER_READ_ABC_FEATURES_H
