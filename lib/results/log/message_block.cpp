#include "results/log/message_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

constexpr std::size_t kept_lines = 4096;
constexpr std::size_t indent_of_text = 3;

/// A loop: the library's own search for one of several characters calls a function for each one that it looks at.
inline std::size_t indent(std::string_view line) {
  std::size_t at = 0;
  while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) ++at;
  return at;
}

/// As trimmed(); inlined, since it is called for every line of a block.
inline std::string_view inner(std::string_view text) {
  const std::size_t begin = indent(text);
  std::size_t end = text.size();
  while (end > begin && (text[end - 1] == ' ' || text[end - 1] == '\t')) --end;
  return text.substr(begin, end - begin);
}

bool begins(std::string_view text, std::string_view lower_case) {
  return text.size() >= lower_case.size() &&
         std::equal(lower_case.begin(), lower_case.end(), text.begin(),
                    [](char l, char c) { return l == (c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c); });
}

/// The word after "*** " if it is one of the two; empty otherwise.
std::string_view severity_word(std::string_view line) {
  line.remove_prefix(indent(line));
  if (!line.starts_with("*** ")) return {};
  line.remove_prefix(4);
  if (begins(line, "warning")) return line.substr(0, 7);
  if (begins(line, "error")) return line.substr(0, 5);
  return {};
}

/// " 9 t 1.0000E-01 dt ...": the solver continues, whatever comes before.
bool is_cycle(std::string_view trimmed_line) {
  const std::size_t at = trimmed_line.find_first_not_of("0123456789");
  return at != std::string_view::npos && at > 0 && trimmed_line.substr(at).starts_with(" t ");
}

bool is_id_list(std::string_view trimmed_line) {
  return trimmed_line.find_first_not_of("0123456789 \t*") == std::string_view::npos &&
         trimmed_line.find_first_of("0123456789") != std::string_view::npos;
}

/// Errors in the input quote the card between rules, below the path of its file.
enum class Quote { none, path, rule, card };

Quote after(Quote quote, std::string_view line) {
  if (line.ends_with("of file")) return Quote::path;
  if (quote == Quote::path) return Quote::rule;
  const bool rule = line.starts_with("-----");
  if (quote == Quote::rule && rule) return Quote::card;
  return quote == Quote::card && !rule ? Quote::card : Quote::none;
}

/// The minimum indent of the block's lines: the solver's own, or less if blanks were lost (texts copied through mails
/// and tickets). A header with its own text needs no such lines.
std::size_t least_indent(std::string_view first_line, const MessageBlock& block) {
  return block.header_text ? indent_of_text : std::min(indent_of_text, indent(first_line));
}

bool belongs(std::string_view line, std::string_view trimmed_line, Quote quote, std::size_t least) {
  if (trimmed_line.empty()) return quote == Quote::card;
  if (trimmed_line.starts_with("*** ")) return false;
  if (quote == Quote::path || quote == Quote::card) return true;
  if (quote == Quote::rule && trimmed_line.starts_with("-----")) return true;
  if (is_id_list(trimmed_line)) return true;
  return indent(line) >= least && !is_cycle(trimmed_line);
}

void read_header(std::string_view line, MessageBlock& block) {
  const std::string_view word = severity_word(line);
  block.severity = begins(word, "error") ? Severity::error : Severity::warning;
  std::string_view rest = trimmed(line.substr(static_cast<std::size_t>(word.data() + word.size() - line.data())));
  std::string_view after_code = rest;
  if (const auto code = take_integer(after_code); code && *code > 0) {
    block.code = *code;
    rest = trimmed(after_code);
  }
  if (rest.starts_with('(')) {
    const std::size_t close = rest.find(')');
    const std::string_view code_name = rest.substr(0, close).substr(1);
    block.group = code_name.substr(0, code_name.find('+'));
    rest = close == std::string_view::npos ? std::string_view{} : trimmed(rest.substr(close + 1));
  }
  block.header_text = !rest.empty();
  if (block.header_text) block.lines.push_back(rest);
}

}  // namespace

std::uint32_t MessageBlock::line_of(std::size_t i) const {
  return line + static_cast<std::uint32_t>(i) + (header_text ? 0 : 1);
}

bool is_message_header(std::string_view line) { return !severity_word(line).empty(); }

void read_message_block(Lines& lines, MessageBlock& block) {
  block.lines.clear();
  block.code = 0;
  block.group = {};
  block.left_out = 0;
  block.line = lines.number();
  read_header(lines.line(), block);
  Quote quote = Quote::none;
  std::optional<std::size_t> least;
  constexpr std::size_t longest_quote = 100;
  for (std::size_t quoted = 0;;) {
    block.open = lines.open();
    lines.advance();
    if (lines.done()) break;
    const std::string_view text = inner(lines.line());
    if (!least) least = least_indent(lines.line(), block);
    if (!belongs(lines.line(), text, quote, *least)) {
      // Blanks without a line end: the file was cut in the indent of the next line.
      block.open = text.empty() && lines.open();
      break;
    }
    quote = after(quote, text);
    // A rule that is never closed must not consume the rest of the file.
    if (quote == Quote::card && ++quoted > longest_quote) quote = Quote::none;
    if (block.lines.size() < kept_lines)
      block.lines.push_back(text);
    else
      ++block.left_out;
  }
  block.ends_file = lines.done() || block.open;
}

std::optional<Field> field(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  return Field{inner(line.substr(0, equals)), inner(line.substr(equals + 1))};
}

std::vector<Field> fields(std::string_view line) {
  std::vector<Field> list;
  for (std::size_t equals = line.find('='); equals != std::string_view::npos; equals = line.find('=')) {
    const std::string_view label = inner(line.substr(0, equals)), behind = line.substr(equals + 1);
    line = behind;
    if (behind.find('=') == std::string_view::npos)
      line = line.substr(line.size());
    else
      for (std::string_view after = line; take_real(after);) line = after;
    list.push_back({label, inner(behind.substr(0, behind.size() - line.size()))});
  }
  return list;
}

std::string joined_text(const MessageBlock& block, std::size_t limit) {
  std::string text;
  std::size_t left_out = block.left_out;
  for (const std::string_view line : block.lines) {
    if (text.size() + line.size() > limit) {
      ++left_out;
      continue;
    }
    bool blank = !text.empty();
    for (const char c : line) {
      if (c == ' ' || c == '\t') {
        blank = true;
        continue;
      }
      if (blank && !text.empty()) text += ' ';
      blank = false;
      text += c;
    }
  }
  if (left_out > 0) text += fmt::format(" [{} more line{}]", left_out, left_out == 1 ? "" : "s");
  return text;
}

std::uint64_t text_hash(const MessageBlock& block) {
  std::uint64_t hash = 14695981039346656037u + block.left_out;
  for (const std::string_view line : block.lines) hash = (hash ^ std::hash<std::string_view>{}(line)) * 1099511628211u;
  return hash;
}

}  // namespace gapcheck::results
