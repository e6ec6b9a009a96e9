// A picture of pixels, on which discs and lines with smooth borders are drawn.

#ifndef EXTRACT_WIREFRAME_CANVAS_H
#define EXTRACT_WIREFRAME_CANVAS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tool {

typedef std::array<double, 2> Pixel_position; // the middle of the first pixel is (0.5, 0.5)
typedef std::array<float, 3> Pixel_colour;    // each from 0 to 1

class Canvas
{
public:
  Canvas(std::size_t width, std::size_t height, const Pixel_colour& background)
    : m_width(width), m_height(height), m_pixels(width * height, background), m_coverage(width * height, 0.f)
  {}

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }
  const Pixel_colour& pixel(std::size_t x, std::size_t y) const { return m_pixels[y * m_width + x]; }

  void draw_disc(const Pixel_position& center, double radius, const Pixel_colour& colour)
  {
    cover(center, center, radius);
    blend(colour, 1.f);
  }

  // All of it is covered evenly, also where it crosses itself.
  void draw_polyline(const std::vector<Pixel_position>& points, double width, const Pixel_colour& colour, float opacity)
  {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      cover(points[i], points[i + 1], 0.5 * width);
    blend(colour, opacity);
  }

private:
  // Notes how much of each pixel is nearer to a segment than that: by the distance of its middle.
  void cover(const Pixel_position& begin, const Pixel_position& end, double radius)
  {
    std::array<std::size_t, 2> first, last;
    const std::array<std::size_t, 2> size = {{m_width, m_height}};
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double low = (std::min)(begin[i], end[i]) - radius - 1.;
      const double high = (std::max)(begin[i], end[i]) + radius + 1.;
      if (!(high > 0.) || !(low < static_cast<double>(size[i])))
        return;
      first[i] = static_cast<std::size_t>((std::max)(low, 0.));
      last[i] = (std::min)(static_cast<std::size_t>(high), size[i] - 1);
    }
    for (std::size_t y = first[1]; y <= last[1]; ++y)
      for (std::size_t x = first[0]; x <= last[0]; ++x)
      {
        const Pixel_position middle = {{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5}};
        const double share = (std::min)(radius + 0.5 - distance_to_segment(middle, begin, end), 1.);
        if (share > 0.)
          cover_pixel(y * m_width + x, static_cast<float>(share));
      }
  }

  void cover_pixel(std::size_t index, float share)
  {
    if (m_coverage[index] == 0.f)
      m_covered.push_back(index);
    m_coverage[index] = (std::max)(m_coverage[index], share);
  }

  void blend(const Pixel_colour& colour, float opacity)
  {
    for (const std::size_t index : m_covered)
    {
      for (std::size_t i = 0; i < 3; ++i)
        m_pixels[index][i] += opacity * m_coverage[index] * (colour[i] - m_pixels[index][i]);
      m_coverage[index] = 0.f;
    }
    m_covered.clear();
  }

  static double distance_to_segment(const Pixel_position& p, const Pixel_position& begin, const Pixel_position& end)
  {
    const double dx = end[0] - begin[0], dy = end[1] - begin[1];
    const double square = dx * dx + dy * dy;
    const double t = square > 0. ? ((p[0] - begin[0]) * dx + (p[1] - begin[1]) * dy) / square : 0.;
    const double inside = (std::min)((std::max)(t, 0.), 1.);
    return std::hypot(p[0] - begin[0] - inside * dx, p[1] - begin[1] - inside * dy);
  }

  const std::size_t m_width, m_height;
  std::vector<Pixel_colour> m_pixels;
  std::vector<float> m_coverage;      // of what is being drawn
  std::vector<std::size_t> m_covered; // pixels of it
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_CANVAS_H
