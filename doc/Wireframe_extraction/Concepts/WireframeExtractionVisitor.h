/*!
\ingroup PkgWireframeExtractionConcepts
\cgalConcept

The concept `WireframeExtractionVisitor` says what `CGAL::extract_wireframe()` asks of the visitor that is
passed with the named parameter `visitor`. Each function is called once, as soon as its stage is done, in the
order in which they stand here and in the thread that called `CGAL::extract_wireframe()`. What a function gets
is valid during the call; to keep it, copy it. If the extraction fails or is cancelled, the functions of the
stages that were not reached are not called.

A visitor is taken by value. To ask it for something afterwards, pass it with `std::ref()`.

`Geom_traits` stands for the geometric traits class of the extraction, a model of
`WireframeExtractionTraits_3`. The functions may be templates.

It is usual to derive from `CGAL::Wireframe_extraction::Default_visitor`, all of whose functions do nothing,
and to write only the functions of interest.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Wireframe_extraction::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::extract_wireframe()`
*/
class WireframeExtractionVisitor
{
public:
  /// \name Functions
  /// @{

  /*!
  is called when the sampling distance is known, estimated or given by the caller. It is in the unit of the
  cloud.
  */
  void sampling_distance_estimated(double sampling_distance);

  /*!
  is called when the distances are estimated. It is not called for a cloud that has distances.
  */
  void field_estimated(const CGAL::Wireframe_extraction::Distance_field& field);

  /*!
  is called when the points near sharp features are selected.
  */
  void skeleton_selected(const CGAL::Wireframe_skeleton<Geom_traits>& skeleton);

  /*!
  is called when every point of the skeleton has its foot, its tangent and its residual, after the field was refined. The
  skeleton may then have other points than the selected one.
  */
  void skeleton_contracted(const CGAL::Wireframe_skeleton<Geom_traits>& skeleton);

  /*!
  is called when the corners are found.
  */
  void corners_detected(const CGAL::Wireframe_skeleton<Geom_traits>& skeleton,
                        const std::vector<CGAL::Wireframe_corner<Geom_traits>>& corners);

  /*!
  is called when the skeleton without its corners is cut into curves. Each cluster holds indices into the
  skeleton.
  */
  void curves_segmented(const CGAL::Wireframe_skeleton<Geom_traits>& skeleton,
                        const std::vector<std::vector<std::size_t>>& clusters);

  /*!
  is called when the topological graph is built.
  */
  void graph_built(const CGAL::Wireframe_graph<Geom_traits>& graph);

  /*!
  is called when the curves are fitted; all of them are splines.
  */
  void curves_fitted(const CGAL::Wireframe<Geom_traits>& wireframe);

  /*!
  is called when lines, circles and ellipses are recognized, with the final result. It is not called if
  `recognize_types` is `false`.
  */
  void types_recognized(const CGAL::Wireframe<Geom_traits>& wireframe);

  /// @}
};
