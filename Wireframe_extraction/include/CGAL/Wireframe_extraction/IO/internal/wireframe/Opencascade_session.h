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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_OPENCASCADE_SESSION_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_OPENCASCADE_SESSION_H

#include <CGAL/Wireframe_extraction/policies.h>

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_SequenceOfPrinters.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Type.hxx>
#include <UnitsMethods.hxx>

#include <locale>
#include <mutex>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// the name of a unit in the settings of OpenCASCADE's translators
inline const char* opencascade_name_of(Wireframe_extraction::Length_unit unit)
{
  typedef Wireframe_extraction::Length_unit Unit;
  switch (unit)
  {
  case Unit::MICROMETER: return "UM";
  case Unit::CENTIMETER: return "CM";
  case Unit::METER: return "M";
  case Unit::INCH: return "INCH";
  case Unit::FOOT: return "FT";
  default: return "MM";
  }
}

// Time with OpenCASCADE: it is silent meanwhile, and its settings, which are global, are as before at the end.
// One session at a time, since its translators do not work in several threads.
class Opencascade_session
{
public:
  Opencascade_session()
    : m_lock(mutex()), m_unit(UnitsMethods::GetCasCadeLengthUnit()), m_printers(Message::DefaultMessenger()->Printers())
  {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }

  Opencascade_session(const Opencascade_session&) = delete;
  Opencascade_session& operator=(const Opencascade_session&) = delete;

  ~Opencascade_session()
  {
    for (auto setting = m_settings.rbegin(); setting != m_settings.rend(); ++setting)
      Interface_Static::SetCVal(setting->first.c_str(), setting->second.c_str());
    UnitsMethods::SetCasCadeLengthUnit(m_unit);
    Message::DefaultMessenger()->ChangePrinters() = m_printers;
  }

  // changes a setting until the end of the session; the translator that knows it has to be initialized
  void set(const char* name, const char* value)
  {
    const bool is_known = Interface_Static::IsPresent(name);
    if (is_known)
      m_settings.emplace_back(name, Interface_Static::CVal(name));
    if (!is_known || !Interface_Static::SetCVal(name, value))
      throw Standard_Failure((std::string("the setting ") + name + " cannot be " + value).c_str());
  }

  // Shapes are in a unit, and so are files. With both the same, no coordinate is converted.
  void set_unit(const char* name_of_file_unit, Wireframe_extraction::Length_unit unit)
  {
    set("xstep.cascade.unit", opencascade_name_of(unit));
    set(name_of_file_unit, opencascade_name_of(unit));
    UnitsMethods::SetCasCadeLengthUnit(Interface_Static::IVal("xstep.cascade.unit"));
  }

private:
  static std::mutex& mutex()
  {
    static std::mutex the_mutex;
    return the_mutex;
  }

  std::lock_guard<std::mutex> m_lock;
  const double m_unit;
  const Message_SequenceOfPrinters m_printers;
  std::vector<std::pair<std::string, std::string>> m_settings;
};

// how OpenCASCADE is to write numbers: with as many digits as its buffers for them hold
inline const char* opencascade_number_format() { return "%#.16G"; }

// Lets `write(session, text, error)` make the text of a file with OpenCASCADE, and puts it into a stream. No
// exception of OpenCASCADE gets out, and no half of a text gets into the stream.
template <class Write>
bool write_with_opencascade(std::ostream& out, Write&& write, std::string& error)
{
  std::ostringstream text;
  text.imbue(std::locale::classic()); // OpenCASCADE relies on a point in numbers
  try
  {
    Opencascade_session session;
    if (!write(session, static_cast<std::ostream&>(text), error))
      return false;
  }
  catch (const Standard_Failure& failure)
  {
    const char* const message = failure.GetMessageString();
    error = std::string("OpenCASCADE cannot hold this wireframe: ") + failure.DynamicType()->Name()
      + (message == nullptr || *message == '\0' ? "" : std::string(", ") + message);
    return false;
  }
  out << text.str();
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_OPENCASCADE_SESSION_H
