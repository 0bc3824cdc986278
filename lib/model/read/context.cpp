#include "model/read/context.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number.hpp"

namespace gapcheck::model {

bool Options::has(std::string_view word) const { return std::find(words.begin(), words.end(), word) != words.end(); }

bool Options::any(std::initializer_list<std::string_view> some) const { return count(some) > 0; }

std::size_t Options::count(std::initializer_list<std::string_view> some) const {
  return static_cast<std::size_t>(std::count_if(some.begin(), some.end(), [&](auto word) { return has(word); }));
}

std::string Context::where(Place place) const {
  if (place.file == none<FileIndex>) return "an unknown place";
  return fmt::format("line {} of {}", place.line, deck.file(place.file).path);
}

void Context::warning(Place place, std::string message) {
  diagnostics.warning(deck.file(place.file).path, place.line, std::move(message));
}

void Context::error(Place place, std::string message) {
  diagnostics.error(deck.file(place.file).path, place.line, std::move(message));
}

void Context::bad_id(Place place, std::string message) {
  if (!diagnostics.has_error_in(deck.file(place.file).path, place.line, place.line)) error(place, std::move(message));
}

void Context::duplicate(std::string_view what, std::int64_t id, Place first, Place again, keyword::IdKind kind) {
  if (cases.never_together({first.file, first.line}, {again.file, again.line})) return;
  model.faults.push_back(
      {Fault::Kind::duplicate_id,
       fmt::format("{} {} is defined again (first in {})", what, id_text(again.file, kind, id), where(first)), again});
}

std::string Context::id_text(FileIndex file, keyword::IdKind kind, std::int64_t id) const {
  const std::int64_t in_file = deck.id_in_file(file, kind, id);
  return in_file == 0 ? fmt::format("{}", id) : fmt::format("{} ({} in the file)", id, in_file);
}

void Context::unknown(std::string message, Place place) {
  model.faults.push_back({Fault::Kind::unknown_reference, std::move(message), place});
}

std::int64_t Context::with_offset(const keyword::Block& block, keyword::IdKind kind, std::int64_t id) const {
  if (id == 0) return 0;
  const std::int64_t offset = transform(block).offset[static_cast<std::size_t>(kind)];
  // Some keywords give an id a special meaning by a minus sign; its number is still shifted.
  std::int64_t moved = 0;
  const bool overflow =
      id > 0 ? __builtin_add_overflow(id, offset, &moved) : __builtin_sub_overflow(id, offset, &moved);
  return overflow ? id : moved;
}

std::int64_t Context::curve_id(const keyword::Block& block, double value) const {
  constexpr double largest = 1e9;
  if (!(value >= 1 && value < largest)) return 0;
  return with_offset(block, keyword::IdKind::function, static_cast<std::int64_t>(value));
}

PartIndex Context::part(std::int64_t id) const {
  const auto found = model.part_of_id.find(id);
  return found == model.part_of_id.end() ? none<PartIndex> : found->second;
}

bool skip_blank(keyword::CardReader& reader) {
  if (!trimmed(reader.peek()).empty()) return false;
  reader.skip();
  return true;
}

void skip_lines(keyword::CardReader& reader, std::int64_t count) {
  for (; count > 0 && !reader.at_end(); --count) reader.skip();
}

}  // namespace gapcheck::model
