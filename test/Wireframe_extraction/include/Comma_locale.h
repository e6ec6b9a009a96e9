// Decimals are written with a comma while this lives, and thousands with a point.

#ifndef COMMA_LOCALE_H
#define COMMA_LOCALE_H

#include <clocale>
#include <locale>
#include <string>

class Comma_locale
{
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
  };

public:
  Comma_locale() : m_before(std::locale::global(std::locale(std::locale::classic(), new Comma)))
  {
    for (const char* const name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) // of C, if there is one
      if (std::setlocale(LC_ALL, name) != nullptr)
        break;
  }

  ~Comma_locale()
  {
    std::setlocale(LC_ALL, "C");
    std::locale::global(m_before);
  }

  Comma_locale(const Comma_locale&) = delete;
  Comma_locale& operator=(const Comma_locale&) = delete;

private:
  const std::locale m_before;
};

#endif // COMMA_LOCALE_H
