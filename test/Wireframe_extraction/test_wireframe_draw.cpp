// CGAL::draw() shows a wireframe: the window is looked at from inside the event loop, and closed.
// usage: test_wireframe_draw [PICTURE.png], in which the window is kept

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/draw_wireframe.h>

#include <QApplication>
#include <QColor>
#include <QImage>
#include <QOpenGLWidget>
#include <QString>
#include <QTimer>

#include <cassert>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Wireframe<Kernel> Wireframe;

QString picture_name;
int number_of_windows = 0;
QImage picture;

// There is no application, thus no timer, until draw() has made one.
void look_at_window()
{
  QTimer::singleShot(1500, [] {
    for (QWidget* const widget : QApplication::topLevelWidgets())
      if (QOpenGLWidget* const viewer = qobject_cast<QOpenGLWidget*>(widget))
      {
        ++number_of_windows;
        picture = viewer->grabFramebuffer();
      }
    QApplication::quit();
  });
}
Q_COREAPP_STARTUP_FUNCTION(look_at_window)

Wireframe frame_with_circle()
{
  Wireframe wireframe;
  wireframe.vertices = {Point(-2, -2, 0), Point(2, -2, 0)};
  Wireframe::Curve line;
  line.type = CGAL::Wireframe_curve_type::LINE;
  line.spline = Wireframe::Curve::Spline(1, {0, 0, 1, 1}, {wireframe.vertices[0], wireframe.vertices[1]});
  line.source = 0;
  line.target = 1;
  Wireframe::Curve circle;
  circle.type = CGAL::Wireframe_curve_type::CIRCLE;
  circle.conic.emplace();
  circle.conic->center = Point(0, 0, 1);
  circle.conic->axis = Kernel::Vector_3(0, 0, 1);
  circle.conic->major_direction = Kernel::Vector_3(1, 0, 0);
  circle.conic->major_radius = circle.conic->minor_radius = 1.5;
  circle.conic->end_angle = 2. * CGAL_PI;
  circle.spline = circle.conic->to_spline(true);
  wireframe.curves = {line, circle};
  return wireframe;
}

// how many pixels have about this colour
int count_pixels(const CGAL::IO::internal::Colour& colour)
{
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
    {
      const QColor pixel = picture.pixelColor(x, y);
      if (std::abs(pixel.red() - colour.red) < 40 && std::abs(pixel.green() - colour.green) < 40
          && std::abs(pixel.blue() - colour.blue) < 40)
        ++count;
    }
  return count;
}

void test_picture()
{
  CGAL::draw(frame_with_circle(), "circle and line");
  assert(number_of_windows == 1);
  if (!picture_name.isEmpty())
    picture.save(picture_name);
  assert(picture.width() >= 200 && picture.height() >= 200);
  const int white = count_pixels({255, 255, 255});
  const int red = count_pixels(CGAL::IO::internal::colour_of(CGAL::Wireframe_curve_type::CIRCLE));
  const int grey = count_pixels(CGAL::IO::internal::colour_of(CGAL::Wireframe_curve_type::LINE));
  std::cout << white << " white, " << red << " red and " << grey << " dark pixels" << std::endl;
  assert(white > picture.width() * picture.height() / 2);
  assert(red > picture.width() / 2);  // the circle is longer than half a window is wide
  assert(grey > picture.width() / 4); // the line, and its vertices
  assert(count_pixels(CGAL::IO::internal::colour_of(CGAL::Wireframe_curve_type::ELLIPSE)) == 0);
}

// what cannot be drawn leaves the window empty
void test_bad_wireframe()
{
  Wireframe wireframe = frame_with_circle();
  wireframe.vertices[0] = Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  CGAL::draw(wireframe);
  assert(number_of_windows == 2);
  assert(count_pixels({255, 255, 255}) > 9 * picture.width() * picture.height() / 10);
}

// as in CGAL's own tests
void test_without_window()
{
  qputenv("CGAL_TEST_SUITE", "1");
  CGAL::draw(frame_with_circle());
  assert(number_of_windows == 2);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc > 1)
    picture_name = QString::fromLocal8Bit(argv[1]);
  test_picture();
  test_bad_wireframe();
  test_without_window();
  return EXIT_SUCCESS;
}
