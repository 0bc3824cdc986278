#include "lsp/position.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace gapcheck::app::lsp {
namespace {

/// Bytes of the character that starts at `at`; 1 for bytes that are not UTF-8.
std::size_t character_length(std::string_view line, std::size_t at) {
  const auto first = static_cast<unsigned char>(line[at]);
  const std::size_t length = first < 0xC2 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 1;
  if (at + length > line.size()) return 1;
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(line[at + i]) & 0xC0) != 0x80) return 1;
  return length;
}

std::size_t units_of(std::size_t length, Encoding encoding) {
  if (encoding == Encoding::utf8) return length;
  return length == 4 ? 2 : 1;
}

bool is_count(const json& value) {
  return value.is_number_unsigned() || (value.is_number_integer() && value.get<std::int64_t>() >= 0);
}

}  // namespace

std::size_t byte_at(std::string_view line, std::size_t units, Encoding encoding) {
  std::size_t at = 0, passed = 0;
  while (at < line.size() && passed < units) {
    const std::size_t length = character_length(line, at);
    passed += units_of(length, encoding);
    if (passed > units) break;
    at += length;
  }
  return at;
}

std::size_t units_before(std::string_view line, std::size_t byte, Encoding encoding) {
  std::size_t at = 0, passed = 0;
  while (at < std::min(byte, line.size())) {
    const std::size_t length = character_length(line, at);
    passed += units_of(length, encoding);
    at += length;
  }
  return passed;
}

bool read_place(const json& position, const Text& text, Encoding encoding, Place& place) {
  const json &line = member(position, {"line"}), &character = member(position, {"character"});
  if (!is_count(line) || !is_count(character)) return false;
  place.line = count_of(line);
  if (place.line >= text.lines()) {
    place = {text.lines() - 1, std::numeric_limits<std::uint32_t>::max()};
    return true;
  }
  place.byte = static_cast<std::uint32_t>(byte_at(text.line(place.line), count_of(character), encoding));
  return true;
}

json range_in(std::string_view line, std::uint32_t number, std::size_t begin, std::size_t end, Encoding encoding) {
  return {{"start", {{"line", number}, {"character", units_before(line, begin, encoding)}}},
          {"end", {{"line", number}, {"character", units_before(line, end, encoding)}}}};
}

json lines_range(std::uint32_t first, std::uint32_t behind) {
  return {{"start", {{"line", first}, {"character", 0}}}, {"end", {{"line", behind}, {"character", 0}}}};
}

json line_edits(std::span<const FixedLine> lines, Encoding encoding, bool open) {
  constexpr std::uint32_t end_of_line = std::numeric_limits<std::int32_t>::max();
  json list = json::array();
  for (const FixedLine& line : lines) {
    json range = lines_range(line.line, line.line);
    range["end"]["character"] = end_of_line;
    if (open) range = range_in(line.before, line.line, 0, line.before.size(), encoding);
    list.push_back({{"range", std::move(range)}, {"newText", line.after}});
  }
  return list;
}

const json& member(const json& value, std::initializer_list<const char*> path) {
  static const json null;
  const json* at = &value;
  for (const char* name : path) {
    if (!at->is_object()) return null;
    const auto found = at->find(name);
    if (found == at->end()) return null;
    at = &*found;
  }
  return *at;
}

const std::string& text_of(const json& value) {
  static const std::string none;
  const auto* text = value.get_ptr<const std::string*>();
  return text != nullptr ? *text : none;
}

bool is_true(const json& value) { return value.is_boolean() && value.get<bool>(); }

std::uint32_t count_of(const json& value, std::uint32_t otherwise) {
  if (!is_count(value)) return otherwise;
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(value.get<std::uint64_t>(), std::numeric_limits<std::uint32_t>::max()));
}

}  // namespace gapcheck::app::lsp
