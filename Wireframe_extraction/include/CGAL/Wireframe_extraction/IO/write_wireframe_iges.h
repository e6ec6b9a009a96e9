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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_IGES_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_IGES_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Opencascade_session.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Opencascade_shape.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <BRep_Tool.hxx>
#include <Geom_Ellipse.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESGeom_ConicArc.hxx>
#include <IGESGeom_TransformationMatrix.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <TColStd_HArray2OfReal.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <UnitsMethods.hxx>
#include <gp_Ax2.hxx>
#include <gp_XY.hxx>
#include <gp_XYZ.hxx>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// OpenCASCADE would write a full ellipse as an approximating spline; the format has it.
inline Handle(IGESGeom_ConicArc) make_iges_ellipse(const TopoDS_Edge& edge)
{
  double first, last;
  const Handle(Geom_Ellipse) ellipse = Handle(Geom_Ellipse)::DownCast(BRep_Tool::Curve(edge, first, last));
  const double a = ellipse->MajorRadius(), b = ellipse->MinorRadius();
  const gp_Ax2& axes = ellipse->Position();
  const gp_XYZ columns[4] = {axes.XDirection().XYZ(), axes.YDirection().XYZ(), axes.Direction().XYZ(),
                             axes.Location().XYZ()};
  const Handle(TColStd_HArray2OfReal) matrix = new TColStd_HArray2OfReal(1, 3, 1, 4);
  for (int row = 1; row <= 3; ++row)
    for (int column = 1; column <= 4; ++column)
      matrix->SetValue(row, column, columns[column - 1].Coord(row));
  const Handle(IGESGeom_TransformationMatrix) placement = new IGESGeom_TransformationMatrix;
  placement->Init(matrix);
  const Handle(IGESGeom_ConicArc) arc = new IGESGeom_ConicArc;
  arc->Init(b * b, 0., a * a, 0., 0., -a * a * b * b, 0., gp_XY(a, 0.), gp_XY(a, 0.));
  arc->InitTransf(placement);
  return arc;
}

// nothing of the time or the place, so that the same wireframe gives the same file
inline void set_iges_header(const Handle(IGESData_IGESModel) & model, const Opencascade_shape& shape)
{
  const auto text = [](const char* value) { return new TCollection_HAsciiString(value); };
  IGESData_GlobalSection header = model->GlobalSection();
  header.SetSendName(text("wireframe"));
  header.SetFileName(text("wireframe.igs"));
  header.SetSystemId(text("Wireframe_extraction"));
  header.SetReceiveName(text("wireframe"));
  header.SetAuthorName(text(""));
  header.SetCompanyName(text(""));
  header.SetDate(text("20000101.000000")); // has to be one
  header.SetLastChangeDate(text("20000101.000000"));
  header.SetResolution(shape.tolerance);
  header.SetMaxCoord(shape.largest_coordinate);
  model->SetGlobalSection(header);
}

template <class GeomTraits, class NamedParameters>
bool write_iges(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
                std::string& error)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  typedef Wireframe_extraction::Length_unit Unit;
  const Unit unit =
    CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::unit), Unit::MILLIMETER);
  return write_with_opencascade(
    out,
    [&](Opencascade_session& session, std::ostream& text, std::string& problem) {
      Opencascade_shape shape;
      if (!make_shape(wireframe, get_geom_traits<GeomTraits>(np), shape, problem))
        return false;
      IGESControl_Controller::Init();
      session.set_unit("write.iges.unit", unit);
      IGESControl_Writer writer(opencascade_name_of(unit), 0);
      const Handle(IGESData_IGESModel) model = writer.Model();
      IGESData_GlobalSection header = model->GlobalSection();
      header.SetCascadeUnit(UnitsMethods::GetCasCadeLengthUnit());
      model->SetGlobalSection(header);
      TopoDS_Iterator child(shape.compound);
      for (std::size_t i = 0; i < shape.children.size(); ++i, child.Next())
      {
        const std::size_t curve = shape.children[i].path.front().first;
        const bool is_ellipse = wireframe.curves[curve].type == Wireframe_curve_type::ELLIPSE;
        if (is_ellipse ? !writer.AddEntity(make_iges_ellipse(shape.edges[curve])) : !writer.AddShape(child.Value()))
        {
          problem = "curve " + std::to_string(curve) + ": OpenCASCADE cannot translate it to IGES";
          return false;
        }
      }
      set_iges_header(model, shape);
      writer.ComputeModel();
      IGESData_IGESWriter iges(model);
      iges.FloatWriter().SetFormat(opencascade_number_format());
      iges.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
      return static_cast<bool>(iges.Print(text));
    },
    error);
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the IGES format, version 5.3.
///
/// The curves are entities 110 (line), 100 (circle or arc), 104 (ellipse or elliptic arc) and 126 (B-spline), after
/// their type. Curves that form a closed loop, with no other curve at any of their vertices, are a composite curve
/// (102). Numbers have 16 digits, and the same wireframe gives the same bytes: the date in the file is always the same.
///
/// The format cannot hold which curves share a vertex (their ends are the same point), a vertex without curve, and
/// what `Wireframe_curve` says of uncertainty, residuals and support. A closed ellipse loses where it starts.
///
/// Needs OpenCASCADE: link the CMake target `CGAL::Wireframe_extraction_OCCT`. The translators of OpenCASCADE have
/// global settings, which are as before when the function returns, and calls from several threads wait for each
/// other; no other thread may use these translators meanwhile. OpenCASCADE prints nothing, and none of its exceptions
/// gets out.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \wireframeParamUnit
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, is malformed
///   in another way, or has a curve that OpenCASCADE has not, such as one of a degree above 25, or the stream cannot
///   be written.
///
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_iges(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(
    stream, np, [&](std::ostream& out, std::string& error) { return internal::write_iges(out, wireframe, np, error); });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the IGES format, version 5.3.
///
/// The content is that of the overload for a stream.
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \wireframeParamUnit
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, is malformed
///   in another way, or has a curve that OpenCASCADE has not, such as one of a degree above 25, or the file cannot
///   be written.
///
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_iges(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_iges(out, wireframe, np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_IGES_H
