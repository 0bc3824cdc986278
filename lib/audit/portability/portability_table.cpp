#include "audit/portability/portability_table.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <span>

#include "base/embedded.hpp"
#include "base/number.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> portability;
}

namespace gapcheck::audit {
namespace {

/// The text before a separator, trimmed; `text` goes on behind it.
std::string_view cut_at(char separator, std::string_view& text) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = trimmed(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

std::vector<std::string_view> words_in(std::string_view text) {
  std::vector<std::string_view> words;
  while (!(text = trimmed(text)).empty()) words.push_back(cut_at(' ', text));
  return words;
}

/// False: the row is not understood.
bool read_kinds(std::string_view row, PortabilityTable& table) {
  ReadKind kind;
  const auto names = words_in(cut_at('|', row));
  for (std::string_view field : words_in(cut_at('|', row))) {
    const bool other = field.ends_with('!');
    if (other) field.remove_suffix(1);
    kind.fields.push_back(field);
    if (other) kind.other_meaning.push_back(field);
  }
  kind.source = trimmed(row);
  if (table.programs.empty() || names.empty() || kind.fields.empty() || kind.source.empty()) return false;
  for (const std::string_view name : names) {
    kind.name = name;
    table.programs.back().kinds.push_back(kind);
  }
  return true;
}

bool read_program(std::string_view row, PortabilityTable& table) {
  OtherProgram program;
  program.name = cut_at('|', row);
  program.source = trimmed(row);
  table.programs.push_back(program);
  return !program.name.empty() && !program.source.empty();
}

bool read_options(std::string_view row, PortabilityTable& table) {
  if (table.programs.empty()) return false;
  OtherProgram& program = table.programs.back();
  program.options = words_in(cut_at('|', row));
  program.option_source = trimmed(row);
  return !program.options.empty() && !program.option_source.empty();
}

bool read_row(std::string_view row, PortabilityTable& table) {
  const std::string_view head = cut_at(' ', row);
  if (head == "program") return read_program(row, table);
  if (head == "option") return read_options(row, table);
  if (head == "reads") return read_kinds(row, table);
  const auto words = words_in(row);
  if (words.size() != 2) return false;
  if (head == "called") return table.names.emplace(words[0], words[1]).second;
  const std::optional<double> value = head == "default" ? parse_real(words[1]) : std::nullopt;
  return value && table.defaults.emplace(words[0], *value).second;
}

}  // namespace

const ReadKind* OtherProgram::find(std::string_view kind) const {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const ReadKind& row) { return row.name == kind; });
  return found == kinds.end() ? nullptr : &*found;
}

std::string PortabilityTable::name_of(std::string_view field) const {
  if (const auto named = names.find(field); named != names.end()) return std::string(named->second);
  std::string name(field);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

PortabilityTable read_portability_table(std::string_view text) {
  PortabilityTable table;
  while (!text.empty()) {
    const std::string_view row = cut_at('\n', text);
    if (!row.empty() && !row.starts_with('#') && !read_row(row, table)) table.faults.push_back(row);
  }
  return table;
}

const PortabilityTable& portability_table() {
  static const PortabilityTable table = read_portability_table(embedded::portability[0].content);
  return table;
}

}  // namespace gapcheck::audit
