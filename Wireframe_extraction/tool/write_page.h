// The page in which the tool extract_wireframe shows what it did, --html. It is compiled apart from the rest.

#ifndef EXTRACT_WIREFRAME_WRITE_PAGE_H
#define EXTRACT_WIREFRAME_WRITE_PAGE_H

#include "Kernel.h"
#include "Stage_recorder.h"
#include "shown_cloud.h"

#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// an option and the value it has in this run
struct Parameter
{
  std::string group, name, value;
  bool is_given; // on the command line
};

// what the page tells, beside the cloud, the stages and the curves
struct Page_texts
{
  std::string title, unit, program;
  std::vector<std::pair<std::string, std::string>> summary;
  std::vector<std::pair<std::string, double>> seconds; // of the stages
  std::vector<std::string> warnings;
  std::vector<Parameter> parameters;
};

// whether the tool was built with the viewer that the page consists of
bool has_viewer();

// Writes the page. The cloud may be empty. What is wrong with the wireframe or the cloud is told in `error`.
bool write_page(std::ostream& stream, const Page_texts& texts, const Cloud& cloud,
                const std::vector<Recorded_stage>& stages, const CGAL::Wireframe<Kernel>& wireframe,
                std::string& error);

} // namespace tool

#endif // EXTRACT_WIREFRAME_WRITE_PAGE_H
