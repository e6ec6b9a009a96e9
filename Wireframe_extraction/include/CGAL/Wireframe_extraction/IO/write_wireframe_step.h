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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_STEP_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_STEP_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Opencascade_session.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Opencascade_shape.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Step_presentation.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_CompositeCurve.hxx>
#include <StepGeom_CompositeCurveSegment.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_HArray1OfCompositeCurveSegment.hxx>
#include <StepShape_GeometricCurveSet.hxx>
#include <StepShape_GeometricSetSelect.hxx>
#include <StepShape_GeometricallyBoundedWireframeShapeRepresentation.hxx>
#include <StepShape_HArray1OfGeometricSetSelect.hxx>
#include <TCollection_HAsciiString.hxx>

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// what the header says of the wireframe, line by line
inline std::vector<std::string> step_description(double sampling_distance, Wireframe_extraction::Length_unit unit,
                                                 const Wireframe_provenance& provenance)
{
  std::vector<std::string> lines(1, "wireframe");
  for (const std::string& input : provenance.inputs)
    lines.push_back("input: " + input);
  if (sampling_distance > 0.)
    lines.push_back("sampling distance: " + number_to_string(sampling_distance) + " " + symbol_of(unit));
  if (provenance.noise_level > 0.)
    lines.push_back("noise level: " + number_to_string(provenance.noise_level) + " " + symbol_of(unit));
  return lines;
}

// nothing of the time, so that the same wireframe gives the same file
inline void set_step_header(const Handle(StepData_StepModel) & model, const std::vector<std::string>& description,
                            const std::string& program)
{
  APIHeaderSection_MakeHeader header(model);
  const auto list = [](const std::vector<std::string>& lines) {
    const Handle(Interface_HArray1OfHAsciiString) array = new Interface_HArray1OfHAsciiString(1, int(lines.size()));
    for (std::size_t i = 0; i < lines.size(); ++i)
      array->SetValue(int(i) + 1, step_text(lines[i]));
    return array;
  };
  header.SetName(step_text("wireframe"));
  header.SetTimeStamp(step_text("2000-01-01T00:00:00")); // has to be one
  header.SetAuthor(list({""}));
  header.SetOrganization(list({""}));
  header.SetAuthorisation(step_text(""));
  header.SetOriginatingSystem(step_text(program.empty() ? "Wireframe_extraction" : program));
  header.SetDescription(list(description));
}

// the first entity of a kind
template <class Entity>
Handle(Entity) find_in_step(const Handle(StepData_StepModel) & model)
{
  Handle(Entity) entity;
  for (int i = 1; i <= model->NbEntities() && entity.IsNull(); ++i)
    entity = Handle(Entity)::DownCast(model->Value(i));
  return entity;
}

// OpenCASCADE counts the products of a process in their names.
inline void name_step_products(const Handle(StepData_StepModel) & model)
{
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (product.IsNull())
      continue;
    product->SetId(step_text("wireframe"));
    product->SetName(step_text("wireframe"));
  }
}

// a closed wire, of which OpenCASCADE writes the curves only
inline Handle(StepGeom_CompositeCurve)
  make_step_loop(const std::vector<Handle(StepGeom_Curve)>& curves, const Opencascade_shape::Path& path)
{
  const Handle(StepGeom_HArray1OfCompositeCurveSegment) segments =
    new StepGeom_HArray1OfCompositeCurveSegment(1, int(path.size()));
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const Handle(StepGeom_CompositeCurveSegment) segment = new StepGeom_CompositeCurveSegment;
    segment->Init(StepGeom_tcContinuous, !path[i].second, curves[i]);
    segments->SetValue(int(i) + 1, segment);
  }
  const Handle(StepGeom_CompositeCurve) loop = new StepGeom_CompositeCurve;
  loop->Init(step_text("loop_of_curve_" + std::to_string(path.front().first)), segments, StepData_LUnknown);
  return loop;
}

inline std::string step_layer(Wireframe_curve_type type, bool is_doubtful)
{
  return is_doubtful ? "DOUBTFUL" : layer_of(type);
}

// Programs that know a loop as a whole only pass over how its curves are shown. Where these are of several kinds, it
// has the colour of splines.
template <class GeomTraits>
void show_step_loop(const Handle(StepGeom_CompositeCurve) & loop, const CGAL::Wireframe<GeomTraits>& wireframe,
                    const Opencascade_shape::Path& path, Step_presentation& presentation)
{
  const Wireframe_curve_type type = wireframe.curves[path.front().first].type;
  bool is_doubtful = false, is_of_one_kind = true;
  for (const auto& step : path)
  {
    is_doubtful = is_doubtful || wireframe.curves[step.first].is_doubtful();
    is_of_one_kind = is_of_one_kind && wireframe.curves[step.first].type == type;
  }
  if (is_of_one_kind)
    presentation.add(loop, type, step_layer(type, is_doubtful));
  else
    presentation.add(loop, Wireframe_curve_type::BSPLINE, is_doubtful ? "DOUBTFUL" : "LOOPS");
}

// Gives the curves their names, colours and layers, and makes one curve of those that form a closed wire.
template <class GeomTraits>
bool arrange_step_curves(const Handle(StepData_StepModel) & model, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const Opencascade_shape& shape, std::string& error)
{
  const Handle(StepShape_GeometricCurveSet) set = find_in_step<StepShape_GeometricCurveSet>(model);
  if (set.IsNull() || set->NbElements() != int(shape.edges.size()))
  {
    error = "OpenCASCADE has not made a STEP curve of every curve";
    return false;
  }
  const Handle(StepShape_HArray1OfGeometricSetSelect) elements =
    new StepShape_HArray1OfGeometricSetSelect(1, int(shape.children.size()));
  Step_presentation presentation;
  int next = 1;
  for (std::size_t i = 0; i < shape.children.size(); ++i)
  {
    const Opencascade_shape::Path& path = shape.children[i].path;
    std::vector<Handle(StepGeom_Curve)> curves;
    for (const auto& step : path)
    {
      const auto& curve = wireframe.curves[step.first];
      curves.push_back(set->ElementsValue(next++).Curve());
      curves.back()->SetName(step_text("curve_" + std::to_string(step.first) + "_" + to_string(curve.type)));
      presentation.add(curves.back(), curve.type, step_layer(curve.type, curve.is_doubtful()));
    }
    StepShape_GeometricSetSelect element;
    if (path.size() == 1)
      element.SetValue(curves.front());
    else
    {
      const Handle(StepGeom_CompositeCurve) loop = make_step_loop(curves, path);
      model->AddWithRefs(loop);
      show_step_loop(loop, wireframe, path, presentation);
      element.SetValue(loop);
    }
    elements->SetValue(int(i) + 1, element);
  }
  set->SetElements(elements);
  presentation.write(model, find_in_step<StepShape_GeometricallyBoundedWireframeShapeRepresentation>(model));
  return true;
}

template <class GeomTraits, class NamedParameters>
bool write_step(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
                std::string& error)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef Wireframe_extraction::Length_unit Unit;
  typedef Wireframe_extraction::Step_schema Schema;
  const Unit unit = choose_parameter(get_parameter(np, internal_np::unit), Unit::MILLIMETER);
  const Schema schema = choose_parameter(get_parameter(np, internal_np::step_schema), Schema::AP214);
  return write_with_opencascade(
    out,
    [&](Opencascade_session& session, std::ostream& text, std::string& problem) {
      Opencascade_shape shape;
      if (!make_shape(wireframe, get_geom_traits<GeomTraits>(np), shape, problem))
        return false;
      STEPControl_Controller::Init();
      session.set_unit("write.step.unit", unit);
      session.set("write.step.schema", schema == Schema::AP242 ? "AP242DIS" : "AP214IS");
      session.set("write.step.assembly", "Off"); // else every loop is a part of its own
      STEPControl_Writer writer;
      writer.SetTolerance(shape.tolerance);
      if (writer.Transfer(shape.compound, STEPControl_GeometricCurveSet) != IFSelect_RetDone)
      {
        problem = "OpenCASCADE cannot translate the wireframe to STEP";
        return false;
      }
      const Handle(StepData_StepModel) model = writer.Model();
      if (!arrange_step_curves(model, wireframe, shape, problem))
        return false;
      const Wireframe_provenance provenance = get_provenance(np);
      set_step_header(model, step_description(CGAL::to_double(wireframe.sampling_distance), unit, provenance),
                      provenance.program);
      name_step_products(model);
      StepData_StepWriter step(model);
      step.FloatWriter().SetFormat(opencascade_number_format());
      step.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
      return static_cast<bool>(step.Print(text));
    },
    error);
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the STEP format (ISO 10303-21).
///
/// The curves are the trimmed curves of a geometric curve set, the kind of wireframe that CAD programs read, as
/// `LINE`, `CIRCLE`, `ELLIPSE` or `B_SPLINE_CURVE`, after their type, and named after their index and type, such as
/// `curve_0_line`. Curves that form a closed loop, with no other curve at any of their vertices, are the segments of a
/// `COMPOSITE_CURVE`. Every kind of curve has a colour and a layer, `LINES`, `CIRCLES`, `ARCS`, `ELLIPSES`,
/// `ELLIPTIC_ARCS` and `SPLINES`; doubtful curves are in the layer `DOUBTFUL` instead. A loop of several kinds is, as a
/// whole, in the layer `LOOPS`. The header names the input, the sampling distance, the noise level and the program, as
/// far as they are known. Numbers have 16 digits, and the same wireframe gives the same bytes: the
/// date in the file is always the same.
///
/// The format cannot hold which curves share a vertex (their ends are the same point), a vertex without curve, and
/// what `Wireframe_curve` says of uncertainty, residuals and support.
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
///   \cgalParamNBegin{step_schema}
///     \cgalParamDescription{the application protocol that the file follows}
///     \cgalParamType{`CGAL::Wireframe_extraction::Step_schema`}
///     \cgalParamDefault{`Step_schema::AP214`}
///   \cgalParamNEnd
///   \wireframeParamProvenance
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
bool write_wireframe_step(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(
    stream, np, [&](std::ostream& out, std::string& error) { return internal::write_step(out, wireframe, np, error); });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the STEP format (ISO 10303-21).
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
///   \cgalParamNBegin{step_schema}
///     \cgalParamDescription{the application protocol that the file follows}
///     \cgalParamType{`CGAL::Wireframe_extraction::Step_schema`}
///     \cgalParamDefault{`Step_schema::AP214`}
///   \cgalParamNEnd
///   \wireframeParamProvenance
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
bool write_wireframe_step(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_step(out, wireframe, np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_STEP_H
