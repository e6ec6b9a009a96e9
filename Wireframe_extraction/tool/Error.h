// How the tool extract_wireframe ends.

#ifndef EXTRACT_WIREFRAME_ERROR_H
#define EXTRACT_WIREFRAME_ERROR_H

#include <stdexcept>
#include <string>

namespace tool {

// what the exit code tells
enum Exit_code
{
  SUCCESS = 0,
  INTERNAL_ERROR = 1,
  USAGE_ERROR = 2,
  BAD_INPUT = 3,
  NO_FEATURE = 4,
  SOME_FAILED = 5,
  BUSY = 6 // of a batch
};

// a failure that ends the tool
struct Error : std::runtime_error
{
  Exit_code exit_code;

  Error(Exit_code code, const std::string& text) : std::runtime_error(text), exit_code(code) {}
};

// the text with blanks for control characters, as scripts and tables can rely on one line
inline std::string one_line(std::string text)
{
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || c == 127)
      c = ' ';
  return text;
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_ERROR_H
