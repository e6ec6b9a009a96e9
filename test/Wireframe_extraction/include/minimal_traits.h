#ifndef MINIMAL_TRAITS_H
#define MINIMAL_TRAITS_H

// The least that is a model of WireframeExtractionTraits_3: it offers nothing beyond the concept and uses no
// type of CGAL, so that code which asks for more does not compile with it.

// A point with the coordinates and nothing else: no operators, not even equality.
struct Minimal_point
{
  Minimal_point() : coordinates{0., 0., 0.} {}
  Minimal_point(double x, double y, double z) : coordinates{x, y, z} {}

  double coordinates[3];
};

// A vector is another type than a point, and neither converts to the other.
struct Minimal_vector
{
  Minimal_vector() : coordinates{0., 0., 0.} {}
  Minimal_vector(double x, double y, double z) : coordinates{x, y, z} {}

  double coordinates[3];
};

struct Minimal_traits
{
  typedef double FT;
  typedef Minimal_point Point_3;
  typedef Minimal_vector Vector_3;

  struct Construct_point_3
  {
    Point_3 operator()(FT x, FT y, FT z) const { return Point_3(x, y, z); }
  };

  struct Construct_vector_3
  {
    Vector_3 operator()(FT x, FT y, FT z) const { return Vector_3(x, y, z); }
  };

  struct Construct_cartesian_const_iterator_3
  {
    const FT* operator()(const Point_3& p) const { return p.coordinates; }
    const FT* operator()(const Point_3& p, int) const { return p.coordinates + 3; }
    const FT* operator()(const Vector_3& v) const { return v.coordinates; }
    const FT* operator()(const Vector_3& v, int) const { return v.coordinates + 3; }
  };

  Construct_point_3 construct_point_3_object() const { return Construct_point_3(); }
  Construct_vector_3 construct_vector_3_object() const { return Construct_vector_3(); }
  Construct_cartesian_const_iterator_3 construct_cartesian_const_iterator_3_object() const
  {
    return Construct_cartesian_const_iterator_3();
  }
};

#endif // MINIMAL_TRAITS_H
