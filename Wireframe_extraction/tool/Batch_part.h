// The part of a list of clouds that a batch extracts.

#ifndef EXTRACT_WIREFRAME_BATCH_PART_H
#define EXTRACT_WIREFRAME_BATCH_PART_H

#include "Error.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>

namespace tool {

// which clouds of the list are those of this run
struct Batch_part
{
  std::size_t number = 1, count = 1;
  bool is_all; // as no part was asked for

  explicit Batch_part(const std::string& text) : is_all(text.empty())
  {
    int end = 0;
    if (!text.empty()
        && (text.size() > 20 || std::sscanf(text.c_str(), "%zu/%zu%n", &number, &count, &end) != 2
            || static_cast<std::size_t>(end) != text.size() || number < 1 || number > count))
      throw Error(USAGE_ERROR, "--part: \"" + text + "\" is not a part K/N, with K from 1 to N");
  }

  std::size_t begin(std::size_t size) const
  {
    return size / count * (number - 1) + (std::min)(number - 1, size % count);
  }

  std::size_t end(std::size_t size) const { return begin(size) + size / count + (number - 1 < size % count ? 1 : 0); }
  std::string name() const { return is_all ? "all" : std::to_string(number) + "-of-" + std::to_string(count); }
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_PART_H
