// Files that tests write to read them.

#ifndef SCRATCH_FILES_H
#define SCRATCH_FILES_H

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

// a file of the current directory that is gone at the end of the test
struct Test_file
{
  std::string name;

  explicit Test_file(const std::string& suffix) : name("scratch" + suffix) {}

  Test_file(const std::string& suffix, const std::string& content) : Test_file(suffix)
  {
    std::ofstream(name, std::ios::binary) << content;
  }

  Test_file(const Test_file&) = delete;
  Test_file& operator=(const Test_file&) = delete;
  ~Test_file() { std::remove(name.c_str()); }

  std::string content() const
  {
    std::ifstream stream(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
};

template <class Number>
void append(Number number, bool is_big, std::string& bytes)
{
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  const std::uint16_t one = 1;
  const bool is_host_big = *reinterpret_cast<const char*>(&one) == 0;
  if (is_big != is_host_big)
    std::reverse(raw, raw + sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

#endif // SCRATCH_FILES_H
