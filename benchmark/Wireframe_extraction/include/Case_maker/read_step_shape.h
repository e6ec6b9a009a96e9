// Copyright (c) 2026 The Wireframe_extraction authors.
// All rights reserved.
//
// This file is part of Wireframe_extraction, a package in the conventions of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Wireframe_extraction authors

#ifndef CASE_MAKER_READ_STEP_SHAPE_H
#define CASE_MAKER_READ_STEP_SHAPE_H

#include <Case_maker/Annotated_shape.h>
#include <Case_maker/Case_error.h>
#include <Case_maker/choose_scale.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Circ.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Case_maker {

struct Step_options
{
  double sharp_angle = 20; ///< degrees between the normals of two faces from which on their edge is sharp
  double sewing = 0;       ///< edges closer than this become one, in the unit of the file; 0: none
};

namespace internal {

/// The true surfaces below the triangles of a mesh.
struct Step_surfaces
{
  std::vector<GeomAdaptor_Surface> surfaces; ///< per patch
  std::vector<Point_2> parameters;           ///< per point of the mesh
  double scale = 1;
  double largest_move = 0; ///< what would move farther stays: near a pole parameters mean little

  Point moved(const Labelled_mesh& mesh, std::size_t triangle, const Point& p) const
  {
    const GeomAdaptor_Surface& surface = surfaces[mesh.patches[triangle]];
    if (surface.GetType() == GeomAbs_Plane)
      return p;
    const Triangle& t = mesh.triangles[triangle];
    const Point& a = mesh.points[t[0]];
    const Point u = mesh.points[t[1]] - a, v = mesh.points[t[2]] - a, w = p - a;
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
    const double det = uu * vv - uv * uv;
    const double x = (wu * vv - wv * uv) / det, y = (wv * uu - wu * uv) / det;
    Point_2 q;
    for (std::size_t k = 0; k < 2; ++k)
      q[k] = (1. - x - y) * parameters[t[0]][k] + x * parameters[t[1]][k] + y * parameters[t[2]][k];
    const gp_Pnt on_surface = surface.Value(q[0], q[1]);
    const Point result = scale * Point{{on_surface.X(), on_surface.Y(), on_surface.Z()}};
    return distance(result, p) <= largest_move ? result : p;
  }
};

/// Makes an annotated shape of a boundary representation.
class Step_shape_builder
{
public:
  Step_shape_builder(const TopoDS_Shape& part, const std::string& path, const Step_options& options)
    : m_part(part), m_path(path), m_options(options)
  {}

  Annotated_shape build(const Scale_rule& rule)
  {
    TopExp::MapShapes(m_part, TopAbs_FACE, m_faces);
    TopExp::MapShapesAndUniqueAncestors(m_part, TopAbs_EDGE, TopAbs_FACE, m_faces_of_edges);
    if (m_faces.IsEmpty())
      throw bad_input("'" + m_path + "' has no faces");
    select_edges();
    std::vector<double> lengths;
    for (const TopoDS_Edge& edge : m_sharp_edges)
      lengths.push_back(GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge)));
    m_scale = choose_scale(lengths, area(), rule, m_shape.remarks);
    add_curves(rule.sampling_distance);
    add_mesh(rule.sampling_distance);
    return std::move(m_shape);
  }

private:
  std::size_t patch_of(const TopoDS_Shape& face) const { return static_cast<std::size_t>(m_faces.FindIndex(face)) - 1; }

  /// finds the sharp edges, and which faces are adjacent.
  void select_edges()
  {
    std::vector<std::set<std::size_t>> neighbors(static_cast<std::size_t>(m_faces.Extent()));
    for (int i = 1; i <= m_faces_of_edges.Extent(); ++i)
    {
      const TopoDS_Edge edge = TopoDS::Edge(m_faces_of_edges.FindKey(i).Oriented(TopAbs_FORWARD));
      std::vector<TopoDS_Face> around;
      for (const TopoDS_Shape& face : m_faces_of_edges.FindFromIndex(i))
        around.push_back(TopoDS::Face(face));
      if (around.empty() || BRep_Tool::Degenerated(edge))
        continue;
      for (const TopoDS_Face& a : around)
        for (const TopoDS_Face& b : around)
          if (!a.IsSame(b))
            neighbors[patch_of(a)].insert(patch_of(b));
      const bool is_seam = around.size() == 1 && BRep_Tool::IsClosed(edge, around[0]);
      if (!is_seam && (around.size() != 2 || is_sharp(edge, around[0], around[1])))
      {
        m_sharp_edges.push_back(edge);
        m_patches_of_edges.emplace_back();
        for (const TopoDS_Face& face : around)
          m_patches_of_edges.back().push_back(patch_of(face));
      }
    }
    for (const std::set<std::size_t>& list : neighbors)
      m_shape.adjacent_patches.emplace_back(list.begin(), list.end());
  }

  /// tells whether the normals differ by more than the angle along most of the edge.
  bool is_sharp(const TopoDS_Edge& edge, const TopoDS_Face& a, const TopoDS_Face& b) const
  {
    // in faces that are oriented alike an edge has opposite orientations
    const double sign = orientation_in(a, edge) == orientation_in(b, edge) ? -1. : 1.;
    const double bound = std::cos(m_options.sharp_angle * pi / 180.);
    double first, last;
    BRep_Tool::Range(edge, first, last);
    const int samples = 9;
    int valid = 0, sharp = 0;
    for (int k = 0; k < samples; ++k)
    {
      const double t = (k + 0.5) / samples;
      Point m, n;
      if (!normal(edge, a, t, m) || !normal(edge, b, t, n))
        continue;
      ++valid;
      sharp += sign * dot(m, n) < bound ? 1 : 0;
    }
    return 2 * sharp > valid;
  }

  static TopAbs_Orientation orientation_in(const TopoDS_Face& face, const TopoDS_Edge& edge)
  {
    for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next())
      if (i.Current().IsSame(edge))
        return i.Current().Orientation();
    return TopAbs_EXTERNAL;
  }

  /// the unit normal of an oriented face at a point of its edge; false where the surface has none
  static bool normal(const TopoDS_Edge& edge, const TopoDS_Face& face, double t, Point& result)
  {
    double first, last;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface.IsNull())
      return false;
    gp_Pnt2d uv;
    if (!curve.IsNull())
      uv = curve->Value(first + t * (last - first));
    else
    {
      BRep_Tool::Range(edge, first, last);
      const gp_Pnt on_edge = BRepAdaptor_Curve(edge).Value(first + t * (last - first));
      uv = ShapeAnalysis_Surface(surface).ValueOfUV(on_edge, 1e-7);
    }
    gp_Pnt p;
    gp_Vec u, v;
    surface->D1(uv.X(), uv.Y(), p, u, v);
    const gp_Vec n = u.Crossed(v);
    const double length = n.Magnitude();
    if (!(length > 1e-9 * u.Magnitude() * v.Magnitude()) || !(length > 0))
      return false;
    const double s = (face.Orientation() == TopAbs_REVERSED ? -1. : 1.) / length;
    result = Point{{s * n.X(), s * n.Y(), s * n.Z()}};
    return true;
  }

  double area() const
  {
    double sum = 0;
    for (int i = 1; i <= m_faces.Extent(); ++i)
    {
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(m_faces(i), properties);
      sum += std::abs(properties.Mass());
    }
    return sum;
  }

  Point scaled(const gp_Pnt& p) const { return m_scale * Point{{p.X(), p.Y(), p.Z()}}; }

  void add_curves(double sampling_distance)
  {
    TopTools_IndexedMapOfShape vertices;
    m_shape.curves_of_patches.resize(static_cast<std::size_t>(m_faces.Extent()));
    for (std::size_t i = 0; i < m_sharp_edges.size(); ++i)
    {
      const BRepAdaptor_Curve adaptor(m_sharp_edges[i]);
      const double first = adaptor.FirstParameter(), last = adaptor.LastParameter();
      Curve curve;
      curve.source = vertex(vertices, TopExp::FirstVertex(m_sharp_edges[i]), adaptor.Value(first));
      curve.target = vertex(vertices, TopExp::LastVertex(m_sharp_edges[i]), adaptor.Value(last));
      const bool is_loop = curve.source == curve.target;
      switch (adaptor.GetType())
      {
      case GeomAbs_Line:
        curve.kind = Curve_kind::LINE;
        curve.start = scaled(adaptor.Value(first));
        curve.end = scaled(adaptor.Value(last));
        break;
      case GeomAbs_Circle:
        curve.kind = is_loop ? Curve_kind::CIRCLE : Curve_kind::ARC;
        set_circle(adaptor.Circle(), first, last, curve);
        break;
      case GeomAbs_Ellipse:
        curve.kind = is_loop ? Curve_kind::ELLIPSE : Curve_kind::ELLIPTIC_ARC;
        set_polyline(adaptor, 0.1 * sampling_distance, curve);
        break;
      default: curve.kind = Curve_kind::SPLINE; set_polyline(adaptor, 0.1 * sampling_distance, curve);
      }
      for (std::size_t patch : m_patches_of_edges[i])
        m_shape.curves_of_patches[patch].push_back(i);
      m_shape.edges.curves.push_back(curve);
    }
    settle_loops(m_shape.edges);
  }

  std::size_t vertex(TopTools_IndexedMapOfShape& vertices, const TopoDS_Vertex& v, const gp_Pnt& p)
  {
    const int known = vertices.Extent();
    const int index = vertices.Add(v); // a curve without vertices has the null vertex: it is a loop
    if (vertices.Extent() > known)
      m_shape.edges.vertices.push_back(scaled(v.IsNull() ? p : BRep_Tool::Pnt(v)));
    return static_cast<std::size_t>(index) - 1;
  }

  void set_circle(const gp_Circ& circle, double first, double last, Curve& curve) const
  {
    const gp_Dir x = circle.XAxis().Direction(), y = circle.YAxis().Direction();
    const Point p = {{x.X(), x.Y(), x.Z()}}, q = {{y.X(), y.Y(), y.Z()}};
    curve.frame.origin = scaled(circle.Location());
    curve.frame.x = std::cos(first) * p + std::sin(first) * q;
    curve.frame.y = std::cos(first) * q - std::sin(first) * p;
    curve.frame.z = cross(p, q);
    curve.radius = m_scale * circle.Radius();
    curve.sweep = last - first;
  }

  /// a polyline so fine that it is the curve for all that is measured here
  void set_polyline(const BRepAdaptor_Curve& adaptor, double step, Curve& curve) const
  {
    const double first = adaptor.FirstParameter(), last = adaptor.LastParameter();
    Curve exact;
    exact.kind = Curve_kind::SPLINE;
    exact.map = [this, &adaptor, first, last](double t) {
      return scaled(adaptor.Value(first + (std::min)(1., (std::max)(0., t)) * (last - first)));
    };
    std::vector<Point> points = exact.sampled(step);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2)
      points = {m_shape.edges.vertices[curve.source], exact.at(0.5), m_shape.edges.vertices[curve.target]};
    curve.set_polyline(points);
  }

  void add_mesh(double sampling_distance)
  {
    const double deflection = 0.02 * sampling_distance;
    BRepMesh_IncrementalMesh(m_part, deflection / m_scale, false, 0.3, false);
    const auto surfaces = std::make_shared<Step_surfaces>();
    surfaces->scale = m_scale;
    surfaces->largest_move = 5 * deflection;
    for (int i = 1; i <= m_faces.Extent(); ++i)
    {
      const TopoDS_Face& face = TopoDS::Face(m_faces(i));
      TopLoc_Location location;
      const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
      if (triangulation.IsNull() || triangulation->NbTriangles() == 0)
        throw bad_input("face " + std::to_string(i) + " of '" + m_path
                        + "' cannot be triangulated; repair the "
                          "part in a CAD program");
      const std::uint32_t first = static_cast<std::uint32_t>(m_shape.mesh.points.size());
      for (int k = 1; k <= triangulation->NbNodes(); ++k)
      {
        m_shape.mesh.points.push_back(scaled(triangulation->Node(k).Transformed(location.Transformation())));
        const gp_Pnt2d uv = triangulation->HasUVNodes() ? triangulation->UVNode(k) : gp_Pnt2d(NAN, NAN);
        surfaces->parameters.push_back({{uv.X(), uv.Y()}});
      }
      for (int k = 1; k <= triangulation->NbTriangles(); ++k)
      {
        int a, b, c;
        triangulation->Triangle(k).Get(a, b, c);
        m_shape.mesh.triangles.push_back(
          {{first + static_cast<std::uint32_t>(a - 1), first + static_cast<std::uint32_t>(b - 1),
            first + static_cast<std::uint32_t>(c - 1)}});
        m_shape.mesh.patches.push_back(static_cast<std::uint32_t>(i - 1));
      }
      surfaces->surfaces.emplace_back(BRep_Tool::Surface(face));
    }
    m_shape.move_to_surface = [surfaces](const Labelled_mesh& mesh, std::size_t triangle, const Point& p) {
      return surfaces->moved(mesh, triangle, p);
    };
  }

  TopoDS_Shape m_part;
  std::string m_path;
  Step_options m_options;
  double m_scale = 1;
  Annotated_shape m_shape;
  TopTools_IndexedMapOfShape m_faces;
  TopTools_IndexedDataMapOfShapeListOfShape m_faces_of_edges;
  std::vector<TopoDS_Edge> m_sharp_edges;
  std::vector<std::vector<std::size_t>> m_patches_of_edges; ///< per sharp edge
};

inline TopoDS_Shape read_step_part(const std::string& path, const Step_options& options)
{
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path))
    throw bad_input("cannot read '" + path + "'; is it a file, and may it be read?");
  STEPControl_Reader reader;
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer)); // it would write to stdout
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw bad_input("'" + path + "' is not a STEP file, or it is damaged");
  reader.TransferRoots();
  TopoDS_Shape part = reader.NbShapes() > 0 ? reader.OneShape() : TopoDS_Shape();
  if (part.IsNull())
    throw bad_input("'" + path + "' has no shape, or only such that OpenCASCADE cannot read");
  if (options.sewing > 0)
  {
    BRepBuilderAPI_Sewing sewing(options.sewing);
    sewing.Add(part);
    sewing.Perform();
    part = sewing.SewedShape();
  }
  return part;
}

} // namespace internal

/// reads a part from a STEP file, and scales it by the rule. Patches are its faces; two are adjacent if they
/// share an edge. An edge is sharp if the normals of its two faces differ by more than an angle along most of
/// it, or if it bounds one face only, or more than two; seams of closed surfaces and degenerate edges are not.
/// Points are on the true surfaces.
inline Annotated_shape read_step_shape(const std::string& path, const Step_options& options, const Scale_rule& rule)
{
  try
  {
    return internal::Step_shape_builder(internal::read_step_part(path, options), path, options).build(rule);
  }
  catch (const Standard_Failure& error)
  {
    throw bad_input("OpenCASCADE fails on '" + path + "': " + error.GetMessageString());
  }
}

} // namespace Case_maker

#endif // CASE_MAKER_READ_STEP_SHAPE_H
