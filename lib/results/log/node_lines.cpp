#include "results/log/node_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/number.hpp"
#include "results/log/message_block.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

bool has(std::string_view text, std::string_view words) { return text.find(words) != std::string_view::npos; }

/// The text after the word and signs such as "#", "ID", "=", ":"; empty if the word is missing.
std::string_view text_after(std::string_view text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at == std::string_view::npos) return {};
  text.remove_prefix(at + word.size());
  for (bool again = true; again;) {
    again = false;
    for (const std::string_view sign : {" ", "#", "=", ":", "ID", "id", "of", "is"})
      if (text.starts_with(sign)) {
        text.remove_prefix(sign.size());
        again = true;
      }
  }
  return text;
}

std::optional<std::int64_t> id_behind(std::string_view text, std::string_view word) {
  std::string_view rest = text_after(text, word);
  rest = rest.substr(0, rest.find_first_not_of("0123456789"));
  const auto id = parse_integer(rest);
  return id && *id > 0 ? id : std::nullopt;
}

/// The first number with a decimal point; the ids have none.
std::optional<double> first_real(std::string_view text) {
  while (!text.empty()) {
    const std::string_view token = take_token(text);
    if (token.find('.') == std::string_view::npos) continue;
    if (const auto number = parse_real(token)) return number;
  }
  return std::nullopt;
}

/// Lines of the input's echo: settings, their explanations, file names.
bool is_echo(std::string_view text) {
  return has(text, "....") || has(text, "eq.") || text.starts_with("Open include file") ||
         text.starts_with("Input file") || text.starts_with("Command line");
}

/// The run's title is above the version stamp and may contain any words.
bool is_title(Lines lines) {
  lines.advance();
  return !lines.done() && trimmed(lines.line()).starts_with("ls-dyna ");
}

}  // namespace

bool NodeLines::count_line(std::string_view text) {
  if (!has(text, "initial penetration")) return false;
  std::string_view rest = text;
  const auto count = take_integer(rest);
  rest = trimmed(rest);
  if (!count || *count < 0 || !rest.starts_with("initial penetration") || !has(rest, "found")) return false;
  const auto id = id_behind(rest, "interface");
  if (!id) return false;
  interface_ = *id;
  collector_.count_penetrations(collector_.slot(*id), static_cast<std::uint64_t>(*count));
  return true;
}

bool NodeLines::warning_summary(Lines& lines, std::string_view text) {
  if (!text.starts_with("Summary of warning messages for interface")) return false;
  const std::uint32_t first = lines.number();
  const auto id = id_behind(text, "interface");
  std::string words(text.substr(0, MessageLog::longest_text));
  lines.advance();
  if (!lines.done() && trimmed(lines.line()).starts_with("number of warning messages")) {
    words += ' ';
    words += trimmed(lines.line()).substr(0, MessageLog::longest_text);
    lines.advance();
  }
  if (id) collector_.slot(*id);
  list(words, first, "interface-warning-count", Severity::note);
  return true;
}

bool NodeLines::initial_summary(Lines& lines, std::string_view text) {
  if (!text.starts_with("summary of initial penetration for interface")) return false;
  const auto id = id_behind(text, "interface");
  InitialSummary summary;
  constexpr int most_lines = 5;
  lines.advance();
  for (int i = 0; i < most_lines && !lines.done(); ++i, lines.advance()) {
    const auto entry = field(lines.line());
    if (!entry) break;
    std::string_view value = entry->value;
    const auto read_count = [&](std::uint64_t& count) {
      if (const auto number = take_integer(value); number && *number > 0) count = static_cast<std::uint64_t>(*number);
    };
    const auto read_depth = [&](double& depth) {
      if (const auto number = take_real(value)) depth = std::abs(*number);
    };
    if (entry->label == "number of warning messages")
      read_count(summary.messages);
    else if (entry->label == "number of penetrating nodes")
      read_count(summary.nodes);
    else if (entry->label == "number of penetrating node eliminated")
      read_count(summary.eliminated);
    else if (entry->label == "min penetration distance")
      read_depth(summary.least);
    else if (entry->label == "max penetration distance")
      read_depth(summary.greatest);
    else
      break;
  }
  if (id) collector_.add_summary(collector_.slot(*id), summary);
  return true;
}

bool NodeLines::mortar(Lines& lines, std::string_view text) {
  if (!text.starts_with("Contact sliding interface")) return false;
  const std::uint32_t first = lines.number();
  if (const auto id = id_behind(text, "interface")) collector_.slot(*id);
  std::string words(text.substr(0, MessageLog::longest_text));
  constexpr int most_lines = 12;
  lines.advance();
  for (int i = 0; i < most_lines && !lines.done(); ++i, lines.advance()) {
    const std::string_view row = trimmed(lines.line());
    if (!row.starts_with("Number of contact pairs") && !row.starts_with("Maximum ") && !row.starts_with("elements "))
      break;
    words += ' ';
    words += row.substr(0, MessageLog::longest_text);
  }
  list(words, first, "mortar-penetration", Severity::note);
  return true;
}

bool NodeLines::node_line(const Lines& lines, std::string_view text) {
  const std::uint32_t line = lines.number();
  const bool moved = has(text, "Moved node") || has(text, "moved node");
  if (moved || has(text, "has penetration")) {
    if (!record(text, line, moved)) list(text, line, "", Severity::warning);
    return true;
  }
  if (collector_.is_d3hsp() || !(has(text, "penetrat") || has(text, "Penetrat")) || is_echo(text) || is_title(lines))
    return false;
  list(text, line, "", Severity::warning);
  return true;
}

bool NodeLines::record(std::string_view text, std::uint32_t line, bool moved) {
  if (const auto id = id_behind(text, "interface")) interface_ = *id;
  auto node = id_behind(text, moved ? "oved node" : "node");
  if (!node) node = id_behind(text, "Node");
  if (interface_ == 0 || !node) return false;
  if (collector_.companion()) return true;
  Penetration record;
  record.contact = collector_.slot(interface_);
  record.node = *node;
  const std::string_view rest = text_after(text, "penetration");
  const auto depth = first_real(rest.empty() ? text : rest);
  record.depth = depth ? std::abs(*depth) : 0;
  record.outcome = moved ? Outcome::moved : Outcome::kept;
  record.file = collector_.file();
  record.line = line;
  collector_.add(record);
  return true;
}

void NodeLines::list(std::string_view text, std::uint32_t line, const std::string& kind, Severity severity) {
  if (collector_.companion()) return;
  MessageLog& log = collector_.messages();
  if (!log.count(severity, 0, kind, std::hash<std::string_view>{}(text), collector_.file())) return;
  log.keep({severity, 0, "", kind, std::string(text.substr(0, MessageLog::longest_text)), 1, collector_.file(), line});
}

}  // namespace gapcheck::results
