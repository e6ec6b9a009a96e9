// Records the result of each stage: as a coloured PLY file, for MeshLab and CloudCompare, and for the page of --html.

#ifndef EXTRACT_WIREFRAME_STAGE_RECORDER_H
#define EXTRACT_WIREFRAME_STAGE_RECORDER_H

#include "Coloured_geometry.h"
#include "Stage_folder.h"
#include "open_input.h"

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// What a stage made, under the name of its file without number and extension.
struct Recorded_stage
{
  std::string name;
  std::size_t count; // of what the stage made: points, corners, clusters, edges or curves
  Coloured_geometry geometry;
};

// Records stage after stage, in files if there is a folder for them, and in memory if that is wanted. Remembers the
// first thing that went wrong, and the files that were written.
class Stage_recorder
{
public:
  Stage_recorder(const Stage_folder& folder, bool is_kept) : m_folder(folder), m_is_kept(is_kept) {}

  const std::string& error() const { return m_error; }
  const std::vector<std::string>& written_files() const { return m_written_files; }
  const std::vector<Recorded_stage>& stages() const { return m_stages; }

  // the page shows the cloud in these colours anyway
  void record_field(Input_cloud& cloud, const CGAL::Wireframe_extraction::Distance_field& field)
  {
    if (!m_folder.is_given() || !m_error.empty())
      return;
    Coloured_geometry geometry("distance");
    std::size_t index = 0;
    const bool is_read = cloud.read([&](const Input_cloud::Sample* first, const Input_cloud::Sample* beyond) {
      for (; first != beyond; ++first, ++index)
      {
        const double distance = field.distances[index];
        if (std::isfinite(distance))
          geometry.add_point(std::array<double, 3>{first->x, first->y, first->z},
                             colour_of_value(distance / field.truncation), distance);
      }
      return true;
    });
    if (is_read)
      write(geometry, 0);
    else
      m_error = cloud.error_message();
  }

  template <class Skeleton>
  void record_skeleton(const Skeleton& skeleton)
  {
    if (!is_on())
      return;
    double largest = 0.;
    for (std::size_t i = 0; i < skeleton.size(); ++i)
      largest = (std::max)(largest, CGAL::to_double(skeleton.distance(i)));
    Coloured_geometry geometry("distance");
    for (std::size_t i = 0; i < skeleton.size(); ++i)
    {
      const double distance = CGAL::to_double(skeleton.distance(i));
      geometry.add_point(skeleton.point(i), colour_of_value(largest > 0. ? distance / largest : 0.), distance);
    }
    record(std::move(geometry), 1, skeleton.size());
  }

  template <class Skeleton>
  void record_feet(const Skeleton& skeleton)
  {
    if (!is_on() || !skeleton.is_contracted())
      return;
    Coloured_geometry geometry("residual");
    for (std::size_t i = 0; i < skeleton.size(); ++i)
    {
      const double residual = CGAL::to_double(skeleton.residual(i));
      geometry.add_point(skeleton.foot(i), colour_of_value(residual / CGAL::to_double(skeleton.sampling_distance())),
                         residual);
    }
    record(std::move(geometry), 2, skeleton.size());
  }

  template <class Skeleton, class Corners>
  void record_corners(const Skeleton& skeleton, const Corners& corners)
  {
    if (!is_on())
      return;
    std::vector<std::size_t> corner_of_point(skeleton.size(), corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (const std::size_t member : corners[i].members)
        if (member < skeleton.size())
          corner_of_point[member] = i;
    Coloured_geometry geometry("corner");
    add_by_index(skeleton, corner_of_point, corners.size(), geometry);
    for (std::size_t i = 0; i < corners.size(); ++i)
      add_ball(corners[i], static_cast<double>(i), geometry);
    record(std::move(geometry), 3, corners.size());
  }

  template <class Skeleton, class Clusters>
  void record_clusters(const Skeleton& skeleton, const Clusters& clusters)
  {
    if (!is_on())
      return;
    std::vector<std::size_t> cluster_of_point(skeleton.size(), clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i)
      for (const std::size_t member : clusters[i])
        if (member < skeleton.size())
          cluster_of_point[member] = i;
    Coloured_geometry geometry("cluster");
    add_by_index(skeleton, cluster_of_point, clusters.size(), geometry);
    record(std::move(geometry), 4, clusters.size());
  }

  template <class Graph>
  void record_graph(const Graph& graph)
  {
    if (!is_on())
      return;
    Coloured_geometry geometry("corner");
    for (const auto v : boost::make_iterator_range(vertices(graph)))
      geometry.add_point(get(CGAL::vertex_point, graph, v), graph[v].is_corner ? corner_colour : grey,
                         graph[v].is_corner ? 1. : 0.);
    for (const auto e : boost::make_iterator_range(edges(graph)))
      geometry.add_edge(source(e, graph), target(e, graph), colour_of_index(graph[e].curve_id));
    record(std::move(geometry), 5, num_edges(graph));
  }

  template <class Wireframe>
  void record_curves(const Wireframe& wireframe)
  {
    if (!is_on() || wireframe.is_empty())
      return;
    CGAL::IO::internal::Sampled_wireframe sampled;
    std::string error;
    if (!sampled.sample(wireframe, 0., typename Wireframe::Geom_traits(), error))
    {
      m_error = "the fitted curves cannot be recorded: " + error;
      return;
    }
    Coloured_geometry geometry("curve");
    // every curve has points of its own, so that each point has the colour of its curve
    for (std::size_t i = 0; i < sampled.polylines.size(); ++i)
    {
      const Colour colour = colour_of_index(i);
      std::size_t last = 0;
      for (std::size_t j = 0; j < sampled.polylines[i].size(); ++j)
      {
        const auto& p = sampled.points[sampled.polylines[i][j]];
        const std::size_t index =
          geometry.add_point(std::array<double, 3>{p[0], p[1], p[2]}, colour, static_cast<double>(i));
        if (j > 0)
          geometry.add_edge(last, index, colour);
        last = index;
      }
    }
    record(std::move(geometry), 6, wireframe.curves.size());
  }

private:
  bool is_on() const { return (m_folder.is_given() || m_is_kept) && m_error.empty(); }

  // what belongs to nothing is grey, with the value -1
  template <class Skeleton>
  static void add_by_index(const Skeleton& skeleton, const std::vector<std::size_t>& index_of_point,
                           std::size_t number_of_indices, Coloured_geometry& geometry)
  {
    for (std::size_t i = 0; i < skeleton.size(); ++i)
    {
      const std::size_t index = index_of_point[i];
      const bool is_free = (index == number_of_indices);
      geometry.add_point(skeleton.is_contracted() ? skeleton.foot(i) : skeleton.point(i),
                         is_free ? grey : colour_of_index(index), is_free ? -1. : static_cast<double>(index));
    }
  }

  // a single point is hard to see: three circles show the ball of the corner
  template <class Corner>
  static void add_ball(const Corner& corner, double value, Coloured_geometry& geometry)
  {
    const std::array<double, 3> center = {CGAL::to_double(corner.center.x()), CGAL::to_double(corner.center.y()),
                                          CGAL::to_double(corner.center.z())};
    const double radius = CGAL::to_double(corner.radius);
    const std::size_t count = 24;
    geometry.add_point(center, corner_colour, value);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::size_t first = 0, last = 0;
      for (std::size_t i = 0; i < count; ++i)
      {
        const double angle = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(count);
        std::array<double, 3> point = center;
        point[axis] += radius * std::cos(angle);
        point[(axis + 1) % 3] += radius * std::sin(angle);
        const std::size_t index = geometry.add_point(point, corner_colour, value);
        if (i == 0)
          first = index;
        else
          geometry.add_edge(last, index, corner_colour);
        last = index;
      }
      geometry.add_edge(last, first, corner_colour);
    }
  }

  void write(const Coloured_geometry& geometry, std::size_t stage)
  {
    const std::string filename = m_folder.path_of(Stage_folder::file_names()[stage]);
    m_error = geometry.write(filename);
    if (m_error.empty())
      m_written_files.push_back(filename);
  }

  void record(Coloured_geometry&& geometry, std::size_t stage, std::size_t count)
  {
    const std::string& file_name = Stage_folder::file_names()[stage];
    if (m_folder.is_given())
      write(geometry, stage);
    if (m_is_kept)
      m_stages.push_back({file_name.substr(2, file_name.find('.') - 2), count, std::move(geometry)});
  }

  const Stage_folder& m_folder;
  const bool m_is_kept;
  std::string m_error;
  std::vector<std::string> m_written_files;
  std::vector<Recorded_stage> m_stages;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_STAGE_RECORDER_H
