// Checks of messages that tests of bad input share.

#ifndef CHECK_WORDS_H
#define CHECK_WORDS_H

#include <cassert>
#include <cstdio>
#include <initializer_list>
#include <string>

typedef std::initializer_list<std::string> Words;

// Every word is in the message, which is one readable line.
inline void check_words(const std::string& error, const Words& words)
{
  for (const std::string& word : words)
    if (error.find(word) == std::string::npos)
    {
      std::fprintf(stderr, "\"%s\" is not in \"%s\"\n", word.c_str(), error.c_str());
      assert(false);
    }
  for (const char c : error)
    assert(static_cast<unsigned char>(c) >= 32 && c != 127); // beyond are letters in UTF-8
}

#endif // CHECK_WORDS_H
