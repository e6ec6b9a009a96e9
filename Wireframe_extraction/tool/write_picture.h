// The picture in which the tool extract_wireframe shows the cloud and the wireframe, --png. It is compiled apart from
// the rest.

#ifndef EXTRACT_WIREFRAME_WRITE_PICTURE_H
#define EXTRACT_WIREFRAME_WRITE_PICTURE_H

#include "Kernel.h"
#include "shown_cloud.h"

#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <iosfwd>
#include <string>

namespace tool {

// from where the picture is taken, as in drawings in .svg
enum class View
{
  TOP,
  ISOMETRIC,
  FRONT,
  RIGHT
};

// whether the tool was built with what writes PNG
bool has_png();

// Writes the picture. What is wrong with the wireframe or the cloud is told in `error`.
bool write_picture(std::ostream& stream, View view, const Cloud& cloud, const CGAL::Wireframe<Kernel>& wireframe,
                   std::string& error);

} // namespace tool

#endif // EXTRACT_WIREFRAME_WRITE_PICTURE_H
