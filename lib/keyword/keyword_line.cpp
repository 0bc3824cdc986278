#include "keyword/keyword_line.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "keyword/text/line_ends.hpp"
#include "keyword/upper_case.hpp"

namespace gapcheck::keyword {
namespace {

/// The letter after `NAME=` among the options of *KEYWORD; NUL if absent.
char option_letter(std::string_view options, std::string_view name) {
  for (auto at = options.find(name); at != std::string_view::npos; at = options.find(name, at + 1)) {
    if (at > 0 && options[at - 1] != ' ' && options[at - 1] != ',') continue;
    const auto rest = trimmed(options.substr(at + name.size()));
    const auto value = rest.starts_with('=') ? trimmed(rest.substr(1)) : std::string_view{};
    if (!value.empty()) return value.front();
  }
  return '\0';
}

Format format_of(std::string_view options, Format inherited) {
  const std::string upper = upper_case(options);
  const char long_fields = option_letter(upper, "LONG"), i10 = option_letter(upper, "I10");
  Format format = inherited;
  if (i10 == 'Y') format = Format::i10;
  if (i10 == 'N' && format == Format::i10) format = Format::standard;
  if (long_fields == 'Y') format = Format::long_fields;
  // K: long output, standard input.
  if ((long_fields == 'S' || long_fields == 'K') && format == Format::long_fields) format = Format::standard;
  return format;
}

}  // namespace

KeywordLine read_keyword_line(std::string_view line, Format& of_file) {
  const auto name_end = std::min({line.find_first_of(" \t"), foreign_break(line), line.size()});
  KeywordLine read;
  read.name = upper_case(line.substr(1, std::max<std::size_t>(name_end, 1) - 1));
  if (read.name == "KEYWORD") of_file = format_of(line.substr(name_end), of_file);
  read.format = of_file;
  const std::string_view rest = trimmed(line.substr(name_end));
  char suffix = read.name.empty() ? '\0' : read.name.back();
  // It may also be all that follows behind blanks.
  const bool apart = suffix != '+' && suffix != '-' && suffix != '%' && rest.size() == 1;
  if (apart) suffix = rest.front();
  if (suffix == '+') read.format = Format::long_fields;
  if (suffix == '-') read.format = Format::standard;
  if (suffix == '%') read.format = Format::i10;
  if (!apart && (suffix == '+' || suffix == '-' || suffix == '%')) read.name.pop_back();
  return read;
}

}  // namespace gapcheck::keyword
