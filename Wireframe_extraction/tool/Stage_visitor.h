// Shows which stage is at work, and records what the stages made.

#ifndef EXTRACT_WIREFRAME_STAGE_VISITOR_H
#define EXTRACT_WIREFRAME_STAGE_VISITOR_H

#include "Progress.h"
#include "Stage_recorder.h"

#include <CGAL/Wireframe_extraction/Default_visitor.h>
#include <CGAL/Wireframe_extraction/Distance_field.h>

#include <functional>

namespace tool {

class Stage_visitor : public CGAL::Wireframe_extraction::Default_visitor
{
  typedef CGAL::Wireframe_extraction::Distance_field Field;

public:
  // `use_field` gets the field if it is estimated
  Stage_visitor(Progress& progress, Stage_recorder& stages, const bool& is_field_known,
                const std::function<void(const Field&)>& use_field)
    : m_progress(progress), m_stages(stages), m_is_field_known(is_field_known), m_use_field(use_field)
  {}

  template <class FT>
  void sampling_distance_estimated(const FT&)
  {
    m_progress.start(m_is_field_known ? "selecting the skeleton" : "estimating the distances");
  }

  void field_estimated(const Field& field)
  {
    m_use_field(field);
    m_progress.start("selecting the skeleton");
  }

  template <class Skeleton>
  void skeleton_selected(const Skeleton& skeleton)
  {
    m_stages.record_skeleton(skeleton);
    m_progress.start("contracting the skeleton");
  }

  template <class Skeleton>
  void skeleton_contracted(const Skeleton& skeleton)
  {
    m_stages.record_feet(skeleton);
    m_progress.start("detecting corners");
  }

  template <class Skeleton, class Corners>
  void corners_detected(const Skeleton& skeleton, const Corners& corners)
  {
    m_stages.record_corners(skeleton, corners);
    m_progress.start("segmenting curves");
  }

  template <class Skeleton, class Clusters>
  void curves_segmented(const Skeleton& skeleton, const Clusters& clusters)
  {
    m_stages.record_clusters(skeleton, clusters);
    m_progress.start("building the graph");
  }

  template <class Graph>
  void graph_built(const Graph& graph)
  {
    m_stages.record_graph(graph);
    m_progress.start("fitting curves");
  }

  template <class Result>
  void curves_fitted(const Result& wireframe)
  {
    m_stages.record_curves(wireframe);
    m_progress.start("recognizing curve types");
  }

private:
  Progress& m_progress;
  Stage_recorder& m_stages;
  const bool& m_is_field_known; // once the cloud was read
  const std::function<void(const Field&)> m_use_field;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_STAGE_VISITOR_H
