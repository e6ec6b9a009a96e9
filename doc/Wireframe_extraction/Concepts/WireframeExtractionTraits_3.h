/*!
\ingroup PkgWireframeExtractionConcepts
\cgalConcept

The concept `WireframeExtractionTraits_3` says what the functions and classes of this package ask of their
geometric traits class: types for numbers, points and vectors, and ways to make points and vectors from
coordinates and to get the coordinates of a point. Nothing else is asked of these types: no operators, no
predicates, and no other constructions. All calculation is in `double`.

A model has to be copy constructible and default constructible.

\cgalRefines{DefaultConstructible, CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{All models of the concept `Kernel` whose number type converts to `double`}
\cgalHasModelsEnd

\sa `CGAL::extract_wireframe()`
*/
class WireframeExtractionTraits_3
{
public:
  /// \name Types
  /// @{

  /*!
  The number type of coordinates and distances. It is constructible from `double`, and `CGAL::to_double()`
  accepts it.
  */
  typedef unspecified_type FT;

  /*!
  The point type. It is default constructible, copyable and assignable.
  */
  typedef unspecified_type Point_3;

  /*!
  The vector type. It is default constructible, copyable and assignable.
  */
  typedef unspecified_type Vector_3;

  /*!
  A function object type that makes a point from its three coordinates:

  `Point_3 operator()(FT x, FT y, FT z) const`
  */
  typedef unspecified_type Construct_point_3;

  /*!
  A function object type that makes a vector from its three coordinates:

  `Vector_3 operator()(FT x, FT y, FT z) const`
  */
  typedef unspecified_type Construct_vector_3;

  /*!
  A function object type that gives access to the coordinates of a point or a vector, by an iterator over three
  values that `CGAL::to_double()` accepts. The iterator is valid as long as the point or vector is. The first function returns
  the iterator to the first coordinate, the second, whose integer argument has no meaning, that behind the
  last one:

  `unspecified_type operator()(const Point_3& p) const`

  `unspecified_type operator()(const Point_3& p, int) const`

  `unspecified_type operator()(const Vector_3& v) const`

  `unspecified_type operator()(const Vector_3& v, int) const`
  */
  typedef unspecified_type Construct_cartesian_const_iterator_3;

  /// @}

  /// \name Operations
  /// @{

  /*!
  returns the function object that makes points.
  */
  Construct_point_3 construct_point_3_object() const;

  /*!
  returns the function object that makes vectors.
  */
  Construct_vector_3 construct_vector_3_object() const;

  /*!
  returns the function object that gives access to coordinates.
  */
  Construct_cartesian_const_iterator_3 construct_cartesian_const_iterator_3_object() const;

  /// @}
};
