// The table in which a batch tells what came out, with a row for each of its clouds.

#ifndef EXTRACT_WIREFRAME_BATCH_SUMMARY_H
#define EXTRACT_WIREFRAME_BATCH_SUMMARY_H

#include "Batch_record.h"
#include "joined.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// what a row says of its cloud
enum class Batch_status : char
{
  PENDING,
  OK,
  SKIPPED,
  FAILED
};

inline const char* to_text(Batch_status status)
{
  switch (status)
  {
  case Batch_status::OK: return "ok";
  case Batch_status::SKIPPED: return "skipped";
  case Batch_status::FAILED: return "failed";
  default: return "pending";
  }
}

inline const char* summary_header()
{
  return "cloud,status,exit_code,error,seconds,processor_seconds,peak_megabytes,points,r,curves,corners,types,doubtful,"
         "rms,mesh,warnings,outputs";
}

// how the table of any version begins
inline const char* summary_mark() { return "cloud,status,exit_code,error,"; }

inline std::string csv_field(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for (const char c : text)
    result += (c == '"') ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

inline std::string csv_number(double value, const char* format)
{
  char text[40];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

// `output_name` is the name of the outputs without their extensions
inline void write_row(std::ostream& stream, const std::string& cloud, const std::string& output_name,
                      Batch_status status, const Batch_record& record)
{
  const Cloud_result& result = record.result;
  stream << csv_field(cloud) << ',' << to_text(status) << ',';
  if (status == Batch_status::PENDING)
  {
    stream << ",,,,,,,,,,,,,,\n";
    return;
  }
  stream << result.exit_code << ',' << csv_field(result.error) << ',' << csv_number(record.seconds, "%.3f") << ','
         << csv_number(record.processor_seconds, "%.3f") << ',' << csv_number(record.peak_megabytes, "%.1f") << ',';
  if (status == Batch_status::FAILED)
    stream << ",,,,,,";
  else
    stream << result.number_of_points << ',' << csv_number(result.sampling_distance, "%.9g") << ','
           << result.number_of_curves << ',' << result.number_of_corners << ',' << csv_field(result.types) << ','
           << result.number_of_doubtful_curves << ',' << csv_number(result.rms, "%.6g");
  const auto text_of_output = [&](const std::pair<std::string, std::uintmax_t>& output) {
    return output_name + "." + output.first;
  };
  const auto text_of_warning = [](const std::string& warning) { return warning; };
  stream << ',' << result.mesh_kind << ',' << csv_field(joined(result.warnings, "; ", text_of_warning)) << ','
         << csv_field(joined(record.outputs, ";", text_of_output)) << '\n';
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_SUMMARY_H
