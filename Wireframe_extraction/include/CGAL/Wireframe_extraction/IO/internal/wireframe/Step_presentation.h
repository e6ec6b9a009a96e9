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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_STEP_PRESENTATION_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_STEP_PRESENTATION_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Opencascade_session.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe_curve_type.h>

#include <STEPConstruct_Styles.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_HArray1OfLayeredItem.hxx>
#include <StepVisual_HArray1OfPresentationStyleAssignment.hxx>
#include <StepVisual_LayeredItem.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

inline Handle(TCollection_HAsciiString) step_text(const std::string& text)
{
  return new TCollection_HAsciiString(text.c_str());
}

// How the curves of a STEP file are shown: a colour for each kind, and layers. These are few entities, which are made
// directly: XCAF, the documents of OpenCASCADE, would make the same ones, but loads its visualization for that.
class Step_presentation
{
  typedef Handle(StepRepr_RepresentationItem) Item;

public:
  void add(const Item& item, Wireframe_curve_type type, const std::string& layer)
  {
    m_items_of_type[type].push_back(item);
    m_items_of_layer[layer].push_back(item);
  }

  // `shown` is the representation that holds the items
  void write(const Handle(StepData_StepModel) & model, const Handle(StepRepr_Representation) & shown) const
  {
    std::vector<Item> styled;
    for (const auto& group : m_items_of_type)
    {
      const Handle(StepVisual_HArray1OfPresentationStyleAssignment) style = style_of(group.first);
      for (const Item& item : group.second)
      {
        const Handle(StepVisual_StyledItem) one = new StepVisual_StyledItem;
        one->Init(step_text(""), style, item);
        styled.push_back(one);
      }
    }
    const Handle(StepRepr_HArray1OfRepresentationItem) items =
      new StepRepr_HArray1OfRepresentationItem(1, int(styled.size()));
    for (std::size_t i = 0; i < styled.size(); ++i)
      items->SetValue(int(i) + 1, styled[i]);
    const Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) presentation =
      new StepVisual_MechanicalDesignGeometricPresentationRepresentation;
    presentation->Init(step_text(""), items, shown->ContextOfItems());
    model->AddWithRefs(presentation);
    for (const auto& group : m_items_of_layer)
      model->AddWithRefs(make_layer(group.first, group.second));
  }

private:
  static Handle(StepVisual_HArray1OfPresentationStyleAssignment) style_of(Wireframe_curve_type type)
  {
    const Colour colour = colour_of(type);
    const Handle(StepVisual_ColourRgb) rgb = new StepVisual_ColourRgb;
    rgb->Init(step_text(to_string(type)), colour.red / 255., colour.green / 255., colour.blue / 255.);
    const Handle(StepVisual_Colour) none;
    const Handle(StepVisual_HArray1OfPresentationStyleAssignment) style =
      new StepVisual_HArray1OfPresentationStyleAssignment(1, 1);
    style->SetValue(1, STEPConstruct_Styles().MakeColorPSA(Item(), none, rgb, none, 0.));
    return style;
  }

  static Handle(StepVisual_PresentationLayerAssignment)
    make_layer(const std::string& name, const std::vector<Item>& items)
  {
    const Handle(StepVisual_HArray1OfLayeredItem) members = new StepVisual_HArray1OfLayeredItem(1, int(items.size()));
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      StepVisual_LayeredItem member;
      member.SetValue(items[i]);
      members->SetValue(int(i) + 1, member);
    }
    const Handle(StepVisual_PresentationLayerAssignment) layer = new StepVisual_PresentationLayerAssignment;
    layer->Init(step_text(name), step_text(""), members);
    return layer;
  }

  std::map<Wireframe_curve_type, std::vector<Item>> m_items_of_type;
  std::map<std::string, std::vector<Item>> m_items_of_layer;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_STEP_PRESENTATION_H
