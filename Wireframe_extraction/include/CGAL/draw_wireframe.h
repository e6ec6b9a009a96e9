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

#ifndef CGAL_DRAW_WIREFRAME_H
#define CGAL_DRAW_WIREFRAME_H

#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <CGAL/version.h>

#ifdef CGAL_USE_BASIC_VIEWER

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/Graphics_scene.h>
#include <CGAL/Qt/Basic_viewer.h>
#else
#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>
#include <QApplication>
#endif

#endif // CGAL_USE_BASIC_VIEWER

#include <cstddef>
#include <iostream>
#include <string>

namespace CGAL {

#ifdef DOXYGEN_RUNNING

/// \ingroup PkgWireframeExtractionFunctions
/// opens a window and draws a wireframe: its curves in the colours of their types, and its vertices.
///
/// The call returns when the window is closed; at once if the macro or the environment variable `CGAL_TEST_SUITE` is
/// set. It needs Qt, which the CMake target `CGAL::Wireframe_extraction_Qt` links; that defines the macro
/// `CGAL_USE_BASIC_VIEWER`, too. Without this macro a message is written to `std::cerr`, and nothing else is done. If
/// the wireframe has a number that is not finite, or is malformed in another way, there is such a message, too, and the
/// window stays empty.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
///
/// \param wireframe the wireframe
/// \param title the title of the window
template <class GeomTraits>
void draw(const CGAL::Wireframe<GeomTraits>& wireframe, const char* title = "Wireframe");

/// \ingroup PkgWireframeExtractionFunctions
/// adds the curves and vertices of a wireframe to a scene, which can be drawn together with other objects.
/// It is there from CGAL 6.0 on, if the macro `CGAL_USE_BASIC_VIEWER` is defined.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
///
/// \param wireframe the wireframe
/// \param scene the scene
template <class GeomTraits>
void add_to_graphics_scene(const CGAL::Wireframe<GeomTraits>& wireframe, CGAL::Graphics_scene& scene);

#elif defined(CGAL_USE_BASIC_VIEWER)

namespace Wireframe_extraction {
namespace internal {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Drawing_kernel;

inline Drawing_kernel::Point_3 drawn_point(const CGAL::IO::internal::Coordinates& point)
{
  return Drawing_kernel::Point_3(point[0], point[1], point[2]);
}

inline CGAL::IO::Color drawn_colour(Wireframe_curve_type type)
{
  const CGAL::IO::internal::Colour colour = CGAL::IO::internal::colour_of(type);
  return CGAL::IO::Color(static_cast<unsigned char>(colour.red), static_cast<unsigned char>(colour.green),
                         static_cast<unsigned char>(colour.blue));
}

// The scene is whatever takes points and segments with colours: the viewer of CGAL 5, the scene of CGAL 6.
template <class GeomTraits, class Scene>
void add_to_scene(const CGAL::Wireframe<GeomTraits>& wireframe, Scene& scene)
{
  CGAL::IO::internal::Sampled_wireframe sampled;
  std::string error;
  if (!sampled.sample(wireframe, 0., GeomTraits(), error))
  {
    std::cerr << "Impossible to draw, " << error << std::endl;
    return;
  }
  for (std::size_t i = 0; i < wireframe.vertices.size(); ++i)
    scene.add_point(drawn_point(sampled.points[i]), CGAL::IO::Color(20, 20, 20));
  for (std::size_t i = 0; i < sampled.polylines.size(); ++i)
    for (std::size_t j = 0; j + 1 < sampled.polylines[i].size(); ++j)
      scene.add_segment(drawn_point(sampled.points[sampled.polylines[i][j]]),
                        drawn_point(sampled.points[sampled.polylines[i][j + 1]]),
                        drawn_colour(wireframe.curves[i].type));
}

} // namespace internal
} // namespace Wireframe_extraction

#if CGAL_VERSION_NR >= 1060000000

template <class GeomTraits>
void add_to_graphics_scene(const CGAL::Wireframe<GeomTraits>& wireframe, CGAL::Graphics_scene& scene)
{
  Wireframe_extraction::internal::add_to_scene(wireframe, scene);
}

template <class GeomTraits>
void draw(const CGAL::Wireframe<GeomTraits>& wireframe, const char* title = "Wireframe")
{
  CGAL::Graphics_scene scene;
  CGAL::add_to_graphics_scene(wireframe, scene);
  CGAL::draw_graphics_scene(scene, title);
}

#else

template <class GeomTraits>
void draw(const CGAL::Wireframe<GeomTraits>& wireframe, const char* title = "Wireframe")
{
#ifdef CGAL_TEST_SUITE
  return;
#endif
  if (qEnvironmentVariableIsSet("CGAL_TEST_SUITE"))
    return;
  CGAL::Qt::init_ogl_context(4, 3);
  int number_of_arguments = 1;
  char name[] = "wireframe_viewer";
  char* arguments[] = {name, nullptr};
  QApplication application(number_of_arguments, arguments);
  // points and segments, each with a colour of its own
  Basic_viewer_qt viewer(application.activeWindow(), title, true, true, false);
  Wireframe_extraction::internal::add_to_scene(wireframe, viewer);
  viewer.show();
  application.exec();
}

#endif

#else // CGAL_USE_BASIC_VIEWER

template <class GeomTraits>
void draw(const CGAL::Wireframe<GeomTraits>&, const char* = "Wireframe")
{
  std::cerr << "Impossible to draw, CGAL_USE_BASIC_VIEWER is not defined." << std::endl;
}

#endif // CGAL_USE_BASIC_VIEWER

} // namespace CGAL

#endif // CGAL_DRAW_WIREFRAME_H
