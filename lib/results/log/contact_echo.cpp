#include "results/log/contact_echo.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/number.hpp"
#include "results/log/message_block.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

/// Value of an echo line "label ...... 12"; the label is the text before the dots. Empty: no such line.
std::string_view echo_value(std::string_view text, std::string_view label) {
  if (!text.starts_with(label)) return {};
  const std::size_t dots = text.find("..", label.size());
  if (dots == std::string_view::npos) return {};
  return trimmed(text.substr(std::min(text.find_first_not_of('.', dots), text.size())));
}

std::optional<std::uint64_t> count_of(std::string_view value) {
  const auto number = parse_integer(value);
  return number && *number >= 0 ? std::optional(static_cast<std::uint64_t>(*number)) : std::nullopt;
}

/// 'A' and 'B' for the words of both vocabularies; nothing for other lines.
std::optional<char> side(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 6> words{
      {{"slave", 'A'}, {"surfa", 'A'}, {"tracked", 'A'}, {"master", 'B'}, {"surfb", 'B'}, {"reference", 'B'}}};
  for (const auto& [word, letter] : words)
    if (text.starts_with(word) && text.substr(word.size()).starts_with(" surface of interface")) return letter;
  return std::nullopt;
}

std::optional<std::uint32_t> order_of(std::string_view value) {
  const auto number = parse_integer(value);
  if (!number || *number <= 0 || *number > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

}  // namespace

bool ContactEcho::interface_heading(Lines& lines, std::string_view text) {
  constexpr std::string_view words = "Contact Interface ";
  if (!text.starts_with(words)) return false;
  std::string_view rest = text.substr(words.size());
  const auto id = take_integer(rest);
  if (!id || *id <= 0 || !trimmed(rest).empty()) return false;
  collector_.mark_d3hsp();
  current_ = collector_.slot(*id);
  ContactSummary& contact = collector_.contact(*current_);
  if (contact.order == 0) contact.order = ++headings_;
  lines.advance();
  if (lines.done() || !trimmed(lines.line()).empty()) return true;
  lines.advance();
  if (lines.done()) return true;
  const std::string_view title = trimmed(lines.line());
  if (contact.title.empty() && echo_value(title, "contact type").empty()) contact.title = title;
  return true;
}

bool ContactEcho::echo_line(std::string_view text) {
  if (!current_) return false;
  ContactSummary& contact = collector_.contact(*current_);
  if (const auto type = echo_value(text, "contact type"); !type.empty()) {
    collector_.set_type(*current_, type, TypeSource::echo);
    return true;
  }
  if (const auto order = order_of(echo_value(text, "contact order within input deck")); order) {
    contact.order = *order;
    return true;
  }
  for (const char* label : {"no. of surfa segments", "no. of slave segments"})
    if (const auto count = count_of(echo_value(text, label)); count) {
      if (contact.segments == 0) contact.segments = *count;
      return true;
    }
  for (const char* label : {"no. of surfb segments", "no. of master segments"})
    if (const auto count = count_of(echo_value(text, label)); count) {
      if (*count > 0) contact.segments = *count;
      return true;
    }
  return false;
}

/// Columns: order 9, id 12, type 7, a blank, title. Wider ids push the rest to the right.
bool ContactEcho::summary_row(std::string_view line) {
  std::string_view rest = line;
  const auto order = order_of(take_token(rest));
  const auto id = take_integer(rest);
  if (!order || !id || *id <= 0) return false;
  constexpr std::size_t type_width = 7;
  const std::string_view type = rest.substr(0, type_width);
  const std::string_view title = rest.size() > type_width ? trimmed(rest.substr(type_width)) : std::string_view{};
  const std::uint32_t slot = collector_.slot(*id);
  ContactSummary& contact = collector_.contact(slot);
  contact.order = *order;
  if (!title.empty()) contact.title = title;
  collector_.set_type(slot, trimmed(type), TypeSource::summary);
  return true;
}

bool ContactEcho::summary(Lines& lines, std::string_view text) {
  if (text != "Contact summary") return false;
  collector_.mark_d3hsp();
  current_.reset();
  const std::uint32_t first = lines.number();
  for (lines.advance(); !lines.done(); lines.advance()) {
    const std::string_view row = trimmed(lines.line());
    if (row.starts_with("***")) return true;
    if (row.empty() || row.starts_with("Order #")) continue;
    if (summary_row(lines.line())) continue;
    collector_.error(lines.number(), "is not a row of the contact summary (order, contact ID, type, title)");
    return true;
  }
  collector_.error(first, "the file ends inside the contact summary");
  return true;
}

bool ContactEcho::surface_timestep(Lines& lines, std::string_view text) {
  const auto letter = side(text);
  const auto heading = letter ? field(text) : std::nullopt;
  if (!heading) return false;
  const std::uint32_t first = lines.number();
  lines.advance();
  std::string_view value = heading->value;
  const auto id = take_integer(value);
  if (!id || *id <= 0) {
    collector_.error(first, "the surface time step names no interface");
    return true;
  }
  SurfaceTimestep step;
  step.contact = collector_.slot(*id);
  step.side = *letter;
  bool read = false, last = false;
  for (; !lines.done() && !last; lines.advance()) {
    const auto entry = field(trimmed(lines.line()));
    if (!entry) break;
    value = entry->value;
    if (entry->label == "type") {
      step.type = value;
      std::erase(step.type, ' ');
      collector_.set_type(step.contact, step.type, TypeSource::timestep);
    } else if (entry->label == "surface timestep") {
      const auto number = take_real(value);
      read = number.has_value();
      step.timestep = number.value_or(0);
    } else if (entry->label.starts_with("controlling")) {
      step.node = take_integer(value).value_or(0);
    } else if (entry->label.starts_with("part ID of")) {
      step.part = take_integer(value).value_or(0);
    } else if (entry->label == "current minimum time step") {
      last = true;
    } else {
      break;
    }
  }
  if (read)
    collector_.add(step);
  else
    collector_.error(first, lines.done() ? "the file ends inside a surface time step block"
                                         : "the surface time step is missing or no number");
  return true;
}

bool ContactEcho::timing_row(std::string_view text) {
  constexpr std::string_view words = "Interf. ID ";
  if (!text.starts_with(words)) return false;
  std::string_view rest = text.substr(words.size());
  const auto id = take_integer(rest);
  const auto seconds = take_real(rest);
  if (!id || *id <= 0 || !seconds) return false;
  double& time = collector_.contact(collector_.slot(*id)).contact_time_s;
  time = std::max(time, *seconds);
  return true;
}

}  // namespace gapcheck::results
