// Many clouds, one after the other and several at once, each in a process of its own. It is compiled apart from the
// extraction, which it calls back for one cloud.

#ifndef EXTRACT_WIREFRAME_RUN_BATCH_H
#define EXTRACT_WIREFRAME_RUN_BATCH_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tool {

struct Batch_options
{
  std::string list;                   // a file that names the clouds, or - for the standard input
  std::string input_folder;           // where relative names start; empty: the folder of the list
  std::string output_folder, summary; // the summary may be empty: it has a name in the output folder then
  std::vector<std::string> formats;   // extensions without their dot
  std::string part;                   // K/N, or empty for all clouds
  int number_of_jobs = 0;             // 0: as many as there are processors
  double time_limit = 0.;             // in seconds, 0: none
  int memory_limit = 0;               // in megabytes, 0: none
  bool are_failed_kept = false, is_quiet = false;
  std::string settings; // everything else that decides on the results
};

// what came out for one cloud
struct Cloud_result
{
  int exit_code = 0;
  std::string error; // in one line, empty if all went well
  std::size_t number_of_points = 0, number_of_curves = 0, number_of_corners = 0;
  std::size_t number_of_doubtful_curves = 0;
  double sampling_distance = 0.;
  double rms = 0.;       // of the residuals
  std::string types;     // how many curves of each kind, for people
  std::string mesh_kind; // cad or scan; empty for what is no mesh
  std::vector<std::string> warnings;
};

// Extracts one cloud and writes the outputs; runs in the cloud's own process, and must not throw.
typedef std::function<Cloud_result(const std::string& cloud, const std::vector<std::string>& outputs)> Extract_cloud;

// How many processors this process may use, at least 1.
int number_of_processors();

// Returns the exit code; throws an Error if there can be no batch.
int run_batch(const Batch_options& options, const Extract_cloud& extract);

} // namespace tool

#endif // EXTRACT_WIREFRAME_RUN_BATCH_H
