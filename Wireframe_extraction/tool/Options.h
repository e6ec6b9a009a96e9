// What the command line of the tool extract_wireframe says, without CLI11, for all who need not know how it is written.

#ifndef EXTRACT_WIREFRAME_OPTIONS_H
#define EXTRACT_WIREFRAME_OPTIONS_H

#include "open_input.h"
#include "run_batch.h"
#include "write_picture.h"

#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <string>
#include <vector>

namespace tool {

// the thresholds of the library with their defaults, which are written there once
typedef CGAL::Wireframe_extraction::internal::Extraction_options Extraction_options;
typedef CGAL::Wireframe_extraction::Length_unit Length_unit;
typedef CGAL::Wireframe_extraction::Step_schema Step_schema;

// whose script of completions is wanted
enum class Completion
{
  NONE,
  BASH,
  ZSH
};

struct Options
{
  Input input;
  std::string output_format; // of what is written to the standard output
  std::string configuration; // where the options go
  bool has_configuration = false;
  Completion completion = Completion::NONE;
  std::string stages_folder;
  std::vector<std::string> outputs;
  std::string html, png, field; // the last one gets the field that was estimated
  std::string shared_features;  // gets the table of what circles have in common
  View view = View::ISOMETRIC;  // of the picture
  bool has_stages = false, has_batch = false, has_html = false, has_png = false, has_field = false,
       has_shared_features = false, is_paper = false, is_quiet = false;
  int number_of_threads = 0; // 0: as many as there are
  int points_in_memory = 1 << 20;
  double sampling_distance = 0.; // 0: to be estimated
  Length_unit unit = Length_unit::MILLIMETER;
  Step_schema step_schema = Step_schema::AP214;
  bool has_obj_splines = false, has_dxf_splines = false, has_dimensions = false;
  double sampling_step = 0., chord_tolerance = 0.; // 0: not given
  Extraction_options extraction;
  Batch_options batch;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_OPTIONS_H
