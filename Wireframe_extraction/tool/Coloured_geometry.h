// Coloured points and edges, which show what a stage made.

#ifndef EXTRACT_WIREFRAME_COLOURED_GEOMETRY_H
#define EXTRACT_WIREFRAME_COLOURED_GEOMETRY_H

#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/write_beside_and_rename.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

struct Colour
{
  unsigned char red, green, blue;
};

const Colour grey = {150, 150, 150};
const Colour corner_colour = {230, 30, 30};

// from blue over green and yellow to red, for 0 to 1
inline Colour colour_of_value(double value)
{
  static const Colour stops[] = {{40, 60, 200}, {30, 170, 200}, {60, 190, 80}, {240, 210, 40}, {220, 40, 30}};
  const double position = 4. * (std::min)((std::max)(value, 0.), 1.);
  const int first = (std::min)(static_cast<int>(position), 3);
  const double t = position - first;
  const auto mix = [t](unsigned char a, unsigned char b) {
    return static_cast<unsigned char>(std::lround((1. - t) * a + t * b));
  };
  const Colour& a = stops[first];
  const Colour& b = stops[first + 1];
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

// neighbouring indices get colours far apart
inline Colour colour_of_index(std::size_t index)
{
  const double hue = 6. * std::fmod(static_cast<double>(index) * 0.6180339887498949, 1.);
  const double strength = (index / 3) % 2 == 0 ? 230. : 160.;
  const auto channel = [hue, strength](double peak) {
    const double away = (std::min)(std::abs(hue - peak), 6. - std::abs(hue - peak));
    return static_cast<unsigned char>(std::lround(strength * (std::min)((std::max)(2. - away, 0.1), 1.)));
  };
  return {channel(0.), channel(2.), channel(4.)};
}

// What a stage made: points, each with a colour and a value, and edges between them.
class Coloured_geometry
{
public:
  // CloudCompare shows the properties m_scalar... of a file under the rest of their names
  explicit Coloured_geometry(const std::string& value_name) : m_value_name(value_name) {}

  template <class Point>
  std::size_t add_point(const Point& point, const Colour& colour, double value)
  {
    return add_point(
      std::array<double, 3>{CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())}, colour,
      value);
  }

  std::size_t add_point(const std::array<double, 3>& point, const Colour& colour, double value)
  {
    m_points.push_back(point);
    m_colours.push_back(colour);
    m_values.push_back(value);
    return m_points.size() - 1;
  }

  void add_edge(std::size_t first, std::size_t second, const Colour& colour)
  {
    m_edges.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second)});
    m_edge_colours.push_back(colour);
  }

  const std::vector<std::array<double, 3>>& points() const { return m_points; }
  const std::vector<Colour>& colours() const { return m_colours; }
  const std::vector<std::array<std::uint32_t, 2>>& edges() const { return m_edges; }
  const std::vector<Colour>& edge_colours() const { return m_edge_colours; }

  // Writes a PLY file. Returns what went wrong, nothing if all went well.
  std::string write(const std::string& filename) const
  {
    std::string error;
    CGAL::IO::internal::write_beside_and_rename(
      filename,
      [this](std::ostream& stream, std::string&) {
        write_header(stream);
        stream << vertex_bytes() << edge_bytes();
        return true;
      },
      error);
    return error;
  }

private:
  static void append_colour(const Colour& colour, std::string& bytes)
  {
    for (const unsigned char channel : {colour.red, colour.green, colour.blue})
      bytes += static_cast<char>(channel);
  }

  std::string vertex_bytes() const
  {
    std::string bytes;
    for (std::size_t i = 0; i < m_points.size(); ++i)
    {
      for (const double coordinate : m_points[i])
        CGAL::IO::internal::append_little_endian(coordinate, bytes);
      append_colour(m_colours[i], bytes);
      CGAL::IO::internal::append_little_endian(m_values[i], bytes);
    }
    return bytes;
  }

  std::string edge_bytes() const
  {
    std::string bytes;
    for (std::size_t i = 0; i < m_edges.size(); ++i)
    {
      for (const std::uint32_t index : m_edges[i])
        CGAL::IO::internal::append_little_endian(index, bytes);
      append_colour(m_edge_colours[i], bytes);
    }
    return bytes;
  }

  void write_header(std::ostream& stream) const
  {
    const std::string colours = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    stream << "ply\nformat binary_little_endian 1.0\nelement vertex " << std::to_string(m_points.size())
           << "\nproperty double x\nproperty double y\nproperty double z\n"
           << colours << "property double scalar_" << m_value_name << '\n';
    if (!m_edges.empty())
      stream << "element edge " << std::to_string(m_edges.size()) << "\nproperty int vertex1\nproperty int vertex2\n"
             << colours;
    stream << "end_header\n";
  }

  std::string m_value_name;
  std::vector<std::array<double, 3>> m_points;
  std::vector<Colour> m_colours;
  std::vector<double> m_values;
  std::vector<std::array<std::uint32_t, 2>> m_edges;
  std::vector<Colour> m_edge_colours;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_COLOURED_GEOMETRY_H
