#include "write_picture.h"

#include "Canvas.h"
#include "Kernel.h"
#include "shown_cloud.h"

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/drawing_views.h>

#include <CGAL/number_utils.h>

#ifdef EXTRACT_WIREFRAME_WITH_PNG
#include <boost/gil.hpp>
#include <boost/gil/extension/io/png.hpp>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

#ifndef EXTRACT_WIREFRAME_WITH_PNG

bool has_png() { return false; }

bool write_picture(std::ostream&, View, const Cloud&, const CGAL::Wireframe<Kernel>&, std::string& error)
{
  error = "the tool was built without libpng";
  return false;
}

#else

bool has_png() { return true; }

namespace {

typedef CGAL::IO::internal::Coordinates Coordinates;
typedef CGAL::IO::internal::Spline_vector Vector;

const double picture_width = 1200., picture_height = 900., margin = 40.;

// Points in space to pixels, at the largest scale at which all are in the picture.
class Projection
{
public:
  explicit Projection(View view) : m_view(CGAL::IO::internal::drawing_views()[static_cast<std::size_t>(view)])
  {
    const Vector &r = m_view.right, &u = m_view.up;
    m_towards = {r.y * u.z - r.z * u.y, r.z * u.x - r.x * u.z, r.x * u.y - r.y * u.x};
  }

  void add(const Coordinates& point)
  {
    const std::array<double, 2> page = {{along(m_view.right, point), along(m_view.up, point)}};
    for (std::size_t i = 0; i < 2; ++i)
    {
      m_low[i] = (std::min)(m_low[i], page[i]);
      m_high[i] = (std::max)(m_high[i], page[i]);
    }
  }

  // pixels per unit
  double scale() const
  {
    return (std::min)((picture_width - 2. * margin) / (m_high[0] - m_low[0]),
                      (picture_height - 2. * margin) / (m_high[1] - m_low[1]));
  }

  Pixel_position operator()(const Coordinates& point) const
  {
    const double s = scale();
    return {{0.5 * picture_width + s * (along(m_view.right, point) - (0.5 * m_low[0] + 0.5 * m_high[0])),
             0.5 * picture_height - s * (along(m_view.up, point) - (0.5 * m_low[1] + 0.5 * m_high[1]))}};
  }

  // how near to the eye
  double height(const Coordinates& point) const { return along(m_towards, point); }

private:
  static constexpr double largest = (std::numeric_limits<double>::max)();

  static double along(const Vector& direction, const Coordinates& p)
  {
    return direction.x * p[0] + direction.y * p[1] + direction.z * p[2];
  }

  const CGAL::IO::internal::Drawing_view& m_view;
  Vector m_towards;
  std::array<double, 2> m_low = {{largest, largest}}, m_high = {{-largest, -largest}};
};

Pixel_colour pixel_colour(const CGAL::IO::internal::Colour& colour)
{
  return {{static_cast<float>(colour.red) / 255.f, static_cast<float>(colour.green) / 255.f,
           static_cast<float>(colour.blue) / 255.f}};
}

// for 0 to 1
Pixel_colour colour_of_distance(double share)
{
  const float position = 4.f * static_cast<float>((std::min)((std::max)(share, 0.), 1.));
  const std::size_t first = (std::min)(static_cast<std::size_t>(position), std::size_t(3));
  const float t = position - static_cast<float>(first);
  const Pixel_colour a = pixel_colour(field_colours()[first]), b = pixel_colour(field_colours()[first + 1]);
  Pixel_colour colour;
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = (1.f - t) * a[i] + t * b[i];
  return colour;
}

// the indices from 0 on in the order of their heights, so that what is nearer is drawn over what is farther
std::vector<std::size_t> from_far_to_near(const std::vector<double>& heights)
{
  std::vector<std::size_t> order(heights.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&heights](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  return order;
}

void draw_cloud(const Cloud& cloud, const std::vector<std::size_t>& indices, const Projection& projection,
                double sampling_distance, Canvas& canvas)
{
  double largest = 0.;
  std::vector<double> heights;
  heights.reserve(indices.size());
  for (const std::size_t i : indices)
  {
    largest = (std::max)(largest, cloud[i].second);
    heights.push_back(projection.height(coordinates_of(cloud[i].first)));
  }
  // as large as that neighbours hardly touch
  const double radius = (std::min)((std::max)(0.45 * sampling_distance * projection.scale(), 0.7), 3.);
  for (const std::size_t i : from_far_to_near(heights))
  {
    const auto& sample = cloud[indices[i]];
    canvas.draw_disc(projection(coordinates_of(sample.first)), radius,
                     colour_of_distance(largest > 0. ? sample.second / largest : 0.));
  }
}

void draw_curves(const CGAL::Wireframe<Kernel>& wireframe, const CGAL::IO::internal::Sampled_wireframe& sampled,
                 const Projection& projection, Canvas& canvas)
{
  std::vector<double> heights;
  for (const auto& polyline : sampled.polylines)
  {
    double sum = 0.;
    for (const std::size_t index : polyline)
      sum += projection.height(sampled.points[index]) / static_cast<double>(polyline.size());
    heights.push_back(sum);
  }
  for (const std::size_t i : from_far_to_near(heights))
  {
    std::vector<Pixel_position> points;
    for (const std::size_t index : sampled.polylines[i])
      points.push_back(projection(sampled.points[index]));
    // a light border parts it from the cloud, and from what is behind
    canvas.draw_polyline(points, 6., {{1.f, 1.f, 1.f}}, 0.75f);
    canvas.draw_polyline(points, 3., pixel_colour(CGAL::IO::internal::colour_of(wireframe.curves[i].type)), 1.f);
  }
  for (std::size_t i = 0; i < wireframe.vertices.size(); ++i)
    canvas.draw_disc(projection(sampled.points[i]), 5., {{0.07f, 0.08f, 0.1f}});
}

void write_png(std::ostream& stream, const Canvas& canvas)
{
  namespace gil = boost::gil;
  gil::rgb8_image_t image(static_cast<std::ptrdiff_t>(canvas.width()), static_cast<std::ptrdiff_t>(canvas.height()));
  const gil::rgb8_view_t pixels = gil::view(image);
  const auto byte = [](float channel) { return static_cast<std::uint8_t>(std::lround(255.f * channel)); };
  for (std::size_t y = 0; y < canvas.height(); ++y)
    for (std::size_t x = 0; x < canvas.width(); ++x)
    {
      const Pixel_colour& colour = canvas.pixel(x, y);
      pixels(static_cast<std::ptrdiff_t>(x), static_cast<std::ptrdiff_t>(y)) =
        gil::rgb8_pixel_t(byte(colour[0]), byte(colour[1]), byte(colour[2]));
    }
  gil::write_view(stream, gil::const_view(image), gil::png_tag());
}

} // namespace

bool write_picture(std::ostream& stream, View view, const Cloud& cloud, const CGAL::Wireframe<Kernel>& wireframe,
                   std::string& error)
{
  CGAL::IO::internal::Sampled_wireframe sampled;
  if (!sampled.sample(wireframe, 0., Kernel(), error))
    return false;
  std::vector<std::size_t> indices = indices_of_valid(cloud);
  Projection projection(view);
  for (const std::size_t i : indices)
    projection.add(coordinates_of(cloud[i].first));
  for (const Coordinates& point : sampled.points)
    projection.add(point);
  if (!std::isfinite(projection.scale()) || !(projection.scale() > 0.))
  {
    error = "the cloud is too large or too small to be drawn; scale it";
    return false;
  }
  shuffle(indices);
  Canvas canvas(static_cast<std::size_t>(picture_width), static_cast<std::size_t>(picture_height),
                {{0.965f, 0.973f, 0.984f}});
  draw_cloud(cloud, indices, projection, CGAL::to_double(wireframe.sampling_distance), canvas);
  draw_curves(wireframe, sampled, projection, canvas);
  write_png(stream, canvas);
  return true;
}

#endif

} // namespace tool
