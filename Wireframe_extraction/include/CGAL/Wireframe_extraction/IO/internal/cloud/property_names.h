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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PROPERTY_NAMES_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PROPERTY_NAMES_H

#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// names of the field's property, in the order in which they are looked for
inline const std::vector<std::string>& known_distance_names()
{
  static const std::vector<std::string> names = {"distance", "distances", "sharpness", "scalar_distance", "quality"};
  return names;
}

// index of a name, an exact match before one that differs in case; `names.size()` if there is none
inline std::size_t find_name(const std::vector<std::string>& names, const std::string& wanted)
{
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == wanted)
      return i;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (to_lower(names[i]) == to_lower(wanted))
      return i;
  return names.size();
}

// what CloudCompare writes before the names of scalar fields
inline const char* scalar_prefix() { return "scalar_"; }

inline std::string without_scalar_prefix(const std::string& name)
{
  return starts_with(to_lower(name), scalar_prefix()) ? name.substr(std::string(scalar_prefix()).size()) : name;
}

// index of the field's property, also behind the prefix of CloudCompare; `names.size()` if there is none
inline std::size_t find_distance_name(const std::vector<std::string>& names, const std::string& wanted)
{
  const std::vector<std::string> candidates =
    wanted.empty() ? known_distance_names() : std::vector<std::string>{wanted};
  for (const std::string& prefix : {std::string(), std::string(scalar_prefix())})
    for (const std::string& candidate : candidates)
    {
      const std::size_t index = find_name(names, prefix + candidate);
      if (index < names.size())
        return index;
    }
  return names.size();
}

// the number of a column, counted from 1, where columns have no names; 0 if the text is none
inline std::size_t column_number(const std::string& text)
{
  std::size_t number = 0;
  return parse_count(text, number) ? number : 0;
}

// index of x, y or z (`k` is 0, 1 or 2): of the name that is wanted, if one is, else also as ParaView calls them
inline std::size_t find_coordinate_name(const std::vector<std::string>& names, std::size_t k,
                                        const std::vector<std::string>& wanted = std::vector<std::string>())
{
  if (k < wanted.size())
    return find_name(names, wanted[k]);
  for (const std::string& name :
       {std::string(1, static_cast<char>('x' + k)), "Points:" + std::to_string(k), "Points_" + std::to_string(k)})
    if (find_name(names, name) < names.size())
      return find_name(names, name);
  return names.size();
}

// what a coordinate is called in messages
inline std::string coordinate_name(std::size_t k, const std::vector<std::string>& wanted)
{
  return k < wanted.size() ? wanted[k] : std::string(1, static_cast<char>('x' + k));
}

// Whether a property is known to be something else than a distance: what scanners and other programs write of a point.
inline bool is_other_name(const std::string& name)
{
  static const std::vector<std::string> names = {"x",
                                                 "y",
                                                 "z",
                                                 "Points:0",
                                                 "Points:1",
                                                 "Points:2",
                                                 "Points_0",
                                                 "Points_1",
                                                 "Points_2",
                                                 "nx",
                                                 "ny",
                                                 "nz",
                                                 "normal_x",
                                                 "normal_y",
                                                 "normal_z",
                                                 "normalx",
                                                 "normaly",
                                                 "normalz",
                                                 "r",
                                                 "g",
                                                 "b",
                                                 "_",
                                                 "a",
                                                 "red",
                                                 "green",
                                                 "blue",
                                                 "alpha",
                                                 "rgb",
                                                 "rgba",
                                                 "diffuse_red",
                                                 "diffuse_green",
                                                 "diffuse_blue",
                                                 "gray",
                                                 "grey",
                                                 "intensity",
                                                 "i",
                                                 "reflectance",
                                                 "reflectivity",
                                                 "confidence",
                                                 "label",
                                                 "class",
                                                 "classification",
                                                 "id",
                                                 "index",
                                                 "time",
                                                 "timestamp",
                                                 "gps_time",
                                                 "curvature",
                                                 "radius",
                                                 "flags",
                                                 "s",
                                                 "t",
                                                 "u",
                                                 "v",
                                                 "texture_u",
                                                 "texture_v"};
  return find_name(names, without_scalar_prefix(name)) < names.size();
}

// What the user shall know of a cloud in which no distance was found: which of its properties could be one, or that the
// only one beside the coordinates is none.
inline std::string no_distance_note(const std::vector<std::string>& names)
{
  std::vector<std::string> unknown;
  for (const std::string& name : names)
    if (!is_other_name(name))
      unknown.push_back(name);
  if (unknown.empty() && names.size() == 4)
    for (const std::string& name : names)
      if (find_coordinate_name({name}, 0) + find_coordinate_name({name}, 1) + find_coordinate_name({name}, 2) == 3)
        return quote(name) + " is no distance, so the file has none; distance_property names it if it is";
  return unknown.empty() ? std::string()
                         : "none of " + join(unknown)
      + " is known to be a distance, so the file has none; distance_property names the one that is";
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PROPERTY_NAMES_H
