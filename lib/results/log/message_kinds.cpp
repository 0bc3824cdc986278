#include "results/log/message_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>

#include "base/embedded.hpp"
#include "base/number.hpp"
#include "results/text/lines.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> message_kinds;
}

namespace gapcheck::results {
namespace {

using Labels = std::array<std::vector<std::string>, MessageKind::label_count>;

constexpr std::array<std::string_view, MessageKind::label_count> label_names{"contact", "node", "segment", "distance",
                                                                             "remaining"};
constexpr std::array tie_reasons{TieReason::sep,       TieReason::offset,  TieReason::too_far, TieReason::too_short,
                                 TieReason::not_found, TieReason::rigslav, TieReason::rigmast, TieReason::conflict};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    if (const auto part = trimmed(text.substr(begin, end - begin)); !part.empty()) parts.push_back(part);
    begin = end + 1;
  }
  return parts;
}

bool read_codes(std::string_view value, MessageKind& kind) {
  while (!trimmed(value).empty()) {
    const auto code = take_integer(value);
    if (!code || *code <= 0) return false;
    kind.codes.push_back(*code);
  }
  return !kind.codes.empty();
}

bool read_words(std::string_view value, MessageKind& kind) {
  for (const std::string_view alternative : split(value, '|')) {
    auto& phrases = kind.words.emplace_back();
    for (const std::string_view phrase : split(alternative, '&')) phrases.push_back(lower_case(std::string(phrase)));
    if (phrases.empty()) return false;
  }
  return !kind.words.empty();
}

bool read_record(std::string_view value, MessageKind& kind) {
  const std::string_view what = take_token(value), reason = take_token(value);
  if (what == "tie") {
    const auto found =
        std::find_if(tie_reasons.begin(), tie_reasons.end(), [&](TieReason r) { return reason == name(r); });
    if (found == tie_reasons.end()) return false;
    kind.reason = *found;
  }
  if (what == "penetration") kind.record = BlockRecord::penetration;
  if (what == "released") kind.record = BlockRecord::released;
  if (what == "tie") kind.record = BlockRecord::tie;
  if (what == "rigidwall") kind.record = BlockRecord::rigidwall;
  if (what == "cut") kind.record = BlockRecord::cut;
  return kind.record != BlockRecord::none;
}

bool read_labels(std::string_view value, std::vector<std::string>& labels) {
  labels.clear();
  for (const std::string_view label : split(value, '|')) labels.emplace_back(label);
  return !labels.empty();
}

/// Reads one line into the last kind, or into the labels of all kinds if there is none yet.
bool read_line(std::string_view line, std::vector<MessageKind>& kinds, Labels& common) {
  const std::string_view key = line.substr(0, line.find_first_of(" \t"));
  const std::string_view value = trimmed(line.substr(key.size()));
  if (key == "kind") {
    if (value.empty()) return false;
    kinds.emplace_back().name = value;
    return true;
  }
  if (const auto at = std::find(label_names.begin(), label_names.end(), key); at != label_names.end()) {
    auto& labels = kinds.empty() ? common : kinds.back().labels;
    return read_labels(value, labels[static_cast<std::size_t>(at - label_names.begin())]);
  }
  if (kinds.empty()) return false;
  if (key == "codes") return read_codes(value, kinds.back());
  if (key == "words") return read_words(value, kinds.back());
  if (key == "wording") {
    kinds.back().assumed = value == "assumed";
    return kinds.back().assumed;
  }
  return key == "record" && read_record(value, kinds.back());
}

/// Lower case, one blank between words.
std::string plain_words(std::string_view text) {
  std::string plain;
  for (const char c : trimmed(text)) {
    const bool blank = c == ' ' || c == '\t';
    if (!blank) plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (blank && plain.back() != ' ') plain += ' ';
  }
  return plain;
}

bool has_words(const MessageKind& kind, const std::string& text) {
  return kind.words.empty() || std::any_of(kind.words.begin(), kind.words.end(), [&](const auto& phrases) {
           return std::all_of(phrases.begin(), phrases.end(),
                              [&](const std::string& phrase) { return text.find(phrase) != std::string::npos; });
         });
}

}  // namespace

std::optional<MessageKind::Label> MessageKind::label_of(std::string_view label) const {
  const auto search = [&](const auto& fits) -> std::optional<Label> {
    for (std::uint8_t what = 0; what < label_count; ++what)
      if (std::any_of(labels[what].begin(), labels[what].end(), fits)) return static_cast<Label>(what);
    return std::nullopt;
  };
  if (const auto exact = search([&](const std::string& known) { return known == label; })) return exact;
  constexpr std::size_t longest = 200;  // joined texts are not much longer
  const std::string wanted = plain_words(label.substr(label.size() - std::min(label.size(), longest)));
  if (const auto same = search([&](const std::string& known) { return plain_words(known) == wanted; })) return same;
  return search(
      [&](const std::string& known) { return known.ends_with('#') && wanted.ends_with(' ' + plain_words(known)); });
}

MessageKinds::MessageKinds() {
  Diagnostics none;  // the built-in table is tested to have no faults
  for (const auto& text : embedded::message_kinds) add(text.content, std::string(text.name), none);
}

void MessageKinds::add(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  std::vector<MessageKind> added;
  std::vector<std::uint32_t> lines_of_kinds;
  Labels common;
  if (!kinds_.empty()) common = kinds_.back().labels;
  for (Lines lines(text); !lines.done(); lines.advance()) {
    const std::string_view line = trimmed(lines.line());
    if (line.empty() || line.front() == '#') continue;
    if (!read_line(line, added, common))
      diagnostics.error(
          file, lines.number(),
          fmt::format("'{}' is not a line of a table of message kinds; see docs/solver-files.md", line.substr(0, 80)));
    if (lines_of_kinds.size() < added.size()) lines_of_kinds.push_back(lines.number());
  }
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (added[i].codes.empty() && added[i].words.empty())
      diagnostics.error(file, lines_of_kinds[i],
                        fmt::format("kind '{}' has neither codes nor words; it fits no message", added[i].name));
    for (std::size_t what = 0; what < common.size(); ++what)
      if (added[i].labels[what].empty()) added[i].labels[what] = common[what];
  }
  std::erase_if(added, [](const MessageKind& kind) { return kind.codes.empty() && kind.words.empty(); });
  kinds_.insert(kinds_.begin(), std::make_move_iterator(added.begin()), std::make_move_iterator(added.end()));
  by_code_.clear();
}

const std::vector<const MessageKind*>& MessageKinds::candidates(std::int64_t code) const {
  constexpr std::size_t most_codes = 10'000;  // more occur only in hostile files
  if (const auto known = by_code_.find(code); known != by_code_.end()) return known->second;
  if (by_code_.size() >= most_codes) by_code_.clear();
  auto& list = by_code_[code];
  for (const MessageKind& kind : kinds_)
    if (kind.codes.empty() || std::find(kind.codes.begin(), kind.codes.end(), code) != kind.codes.end())
      list.push_back(&kind);
  return list;
}

const MessageKind* MessageKinds::find(const MessageBlock& block) const {
  constexpr std::size_t searched_text = 4096;
  std::string text;
  for (const MessageKind* kind : candidates(block.code)) {
    if (!kind->words.empty() && text.empty()) text = lower_case(joined_text(block, searched_text));
    if (has_words(*kind, text)) return kind;
  }
  return nullptr;
}

}  // namespace gapcheck::results
