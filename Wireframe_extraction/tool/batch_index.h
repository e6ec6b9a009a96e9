// The page of a batch: all clouds in one table, with a picture of each that opens its page.

#ifndef EXTRACT_WIREFRAME_BATCH_INDEX_H
#define EXTRACT_WIREFRAME_BATCH_INDEX_H

#include "Batch_record.h"
#include "batch_summary.h"

#include <cstddef>
#include <ostream>
#include <string>

namespace tool {

// the first line, which tells the page of a batch from other pages
inline const char* index_mark() { return "<!doctype html><!-- the clouds of a batch of extract_wireframe -->"; }

inline std::string in_html(const std::string& text)
{
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

// A relative address of a file. Bytes beyond ASCII stand as they are escaped, whatever their encoding.
inline std::string in_address(const std::string& name)
{
  static const char* const digits = "0123456789ABCDEF";
  static const std::string plain = "-._~/";
  std::string result;
  for (const char c : name)
  {
    const unsigned char byte = static_cast<unsigned char>(c);
    const bool is_plain =
      (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || plain.find(c) != std::string::npos;
    result += is_plain ? std::string(1, c) : std::string("%") + digits[byte >> 4] + digits[byte & 15];
  }
  return result;
}

inline void write_index_start(std::ostream& stream)
{
  stream << index_mark() << R"(
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Wireframes</title><style>
:root { color-scheme: light dark } body { font: 15px sans-serif; margin: 1em } table { border-collapse: collapse }
th, td { padding: .3em .6em; text-align: left; border-bottom: 1px solid #8884; vertical-align: top }
th button { all: unset; cursor: pointer; font-weight: bold } th button:focus-visible { outline: 2px solid }
td.number { text-align: right; font-variant-numeric: tabular-nums } img { width: 10em; background: #fff }
tr.failed td { color: #c33 } input { font: inherit; margin-bottom: .6em; width: 20em; max-width: 90% }
</style></head><body><h1>Wireframes</h1>
<p><input id="filter" type="search" placeholder="Filter: a name, failed, a warning" aria-label="Filter the clouds">
<span id="count" role="status"></span></p>
<table><thead><tr>)";
  for (const char* const name : {"", "Cloud", "Status", "Points", "r", "Curves", "Types", "Doubtful", "Residual / r",
                                 "Corners", "Seconds", "Megabytes", "What was said", "Files"})
    stream << "<th scope=\"col\">" << (*name != '\0' ? "<button>" + std::string(name) + "</button>" : std::string())
           << "</th>";
  stream << "</tr></thead><tbody>\n";
}

inline void write_index_number(std::ostream& stream, bool is_known, const std::string& text)
{
  stream << "<td class=\"number\">" << (is_known ? text : std::string()) << "</td>";
}

// `output_name` is the name of the outputs without their extensions
inline void write_index_row(std::ostream& stream, const std::string& cloud, const std::string& output_name,
                            Batch_status status, const Batch_record& record)
{
  const Cloud_result& result = record.result;
  const bool is_tried = status != Batch_status::PENDING, is_well = is_tried && status != Batch_status::FAILED;
  const std::string address = in_address(output_name);
  stream << "<tr class=\"" << to_text(status) << "\"><td>";
  const std::string picture =
    record.has_output("png") ? "<img loading=\"lazy\" alt=\"\" src=\"" + address + ".png\">" : std::string();
  if (record.has_output("html"))
    stream << "<a href=\"" << address << ".html\">" << (picture.empty() ? "page" : picture) << "</a>";
  else
    stream << picture;
  stream << "</td><td>" << in_html(cloud) << "</td><td>" << to_text(status) << "</td>";
  write_index_number(stream, is_well, std::to_string(result.number_of_points));
  write_index_number(stream, is_well, csv_number(result.sampling_distance, "%.4g"));
  write_index_number(stream, is_well, std::to_string(result.number_of_curves));
  stream << "<td>" << (is_well ? in_html(result.types) : std::string()) << "</td>";
  write_index_number(stream, is_well, std::to_string(result.number_of_doubtful_curves));
  write_index_number(stream, is_well && result.sampling_distance > 0.,
                     csv_number(result.rms / result.sampling_distance, "%.3f"));
  write_index_number(stream, is_well, std::to_string(result.number_of_corners));
  write_index_number(stream, is_tried, csv_number(record.seconds, "%.2f"));
  write_index_number(stream, is_tried, csv_number(record.peak_megabytes, "%.0f"));
  stream << "<td>" << in_html(!result.error.empty() ? result.error : joined(result.warnings, "; ")) << "</td><td>";
  for (const auto& output : record.outputs)
    stream << "<a href=\"" << address << '.' << in_address(output.first) << "\">" << in_html(output.first) << "</a> ";
  stream << "</td></tr>\n";
}

// what sorts the rows by a column, and shows those only that have some words
inline void write_index_end(std::ostream& stream)
{
  stream << R"(</tbody></table><script>
const body = document.querySelector("tbody"), rows = [...body.rows], filter = document.getElementById("filter");
const show = () => {
  const words = filter.value.toLowerCase().split(/\s+/);
  let count = 0;
  for (const row of rows) {
    row.hidden = !words.every(word => row.textContent.toLowerCase().includes(word));
    count += row.hidden ? 0 : 1;
  }
  document.getElementById("count").textContent = count + " of " + rows.length;
};
for (const head of document.querySelectorAll("th"))
  head.querySelector("button")?.addEventListener("click", () => {
    const column = head.cellIndex, sign = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    for (const other of document.querySelectorAll("th")) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
    const text = row => row.cells[column].textContent;
    const compared = (a, b) => text(a) === "" || text(b) === "" ? (text(a) === "") - (text(b) === "")
      : sign * (rows[0].cells[column].className === "number" ? text(a) - text(b) : text(a).localeCompare(text(b)));
    body.append(...[...rows].sort(compared));
  });
filter.addEventListener("input", show);
show();
</script></body></html>
)";
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_INDEX_H
