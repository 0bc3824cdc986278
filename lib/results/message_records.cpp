#include "results/message_records.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/number.hpp"
#include "results/printed_number.hpp"

namespace gapcheck::results {
namespace {

/// Reads the values of one block and remembers the first that is none.
class Values {
 public:
  Values(const MessageBlock& block, BlockFault& fault) : block_(block), fault_(fault) {}

  void at(std::size_t line) { line_ = line; }

  bool real(std::string_view& text, std::string_view label, double& value) {
    const std::string_view before = text;
    const auto number = take_real(text);
    if (!number) return unreadable(before, label);
    value = *number;
    return true;
  }

  bool id(std::string_view& text, std::string_view label, std::int64_t& value) {
    const std::string_view before = text;
    const auto number = take_integer(text);
    if (!number || *number <= 0) return unreadable(before, label);
    value = *number;
    return true;
  }

  bool position(std::string_view& text, std::string_view label, std::uint32_t& value) {
    std::int64_t number = 0;
    if (!id(text, label, number)) return false;
    if (number <= std::numeric_limits<std::uint32_t>::max()) value = static_cast<std::uint32_t>(number);
    return true;
  }

  void missing(const char* what) {
    if (fault_.what.empty()) fault_ = {block_.line, fmt::format("message {} does not say the {}", block_.code, what)};
  }

 private:
  bool unreadable(std::string_view text, std::string_view label) {
    if (fault_.what.empty())
      fault_ = {block_.line_of(line_),
                fmt::format("the value of '{}' is no number: '{}'", label.substr(0, 40), trimmed(text).substr(0, 40))};
    return false;
  }

  const MessageBlock& block_;
  BlockFault& fault_;
  std::size_t line_ = 0;
};

/// The coordinates that a block lists: three lines below a heading.
enum class Heading : std::uint8_t { none, nodes, original, modified, recommended };

Heading heading(std::string_view label) {
  if (label.starts_with("original coordinates")) return Heading::original;
  if (label.starts_with("modified coordinates")) return Heading::modified;
  if (label.starts_with("recommended coordinates")) return Heading::recommended;
  return Heading::none;
}

/// Axis of "x-coordinate"; -1: another label.
int axis(std::string_view label) {
  return label.size() == 12 && label[0] >= 'x' && label[0] <= 'z' && label.substr(1) == "-coordinate" ? label[0] - 'x'
                                                                                                      : -1;
}

struct PenetrationReader {
  const MessageKind& kind;
  PenetrationBlock& result;
  Values values;
  Heading under = Heading::none;
  Vector target = Vector::Zero();
  double remaining = 0;
  bool depth = false, remaining_known = false, segment = false, st = false, original = false, modified = false,
       recommended = false;

  void number(Field entry) {
    Penetration& p = result.record;
    std::string_view value = entry.value;
    if (kind.has_label(MessageKind::contact, entry.label)) {
      values.id(value, entry.label, result.contact);
    } else if (kind.has_label(MessageKind::node, entry.label)) {
      values.id(value, entry.label, p.node);
    } else if (kind.has_label(MessageKind::distance, entry.label)) {
      depth = values.real(value, entry.label, p.depth);
      p.depth = std::abs(p.depth);
    } else if (kind.has_label(MessageKind::remaining, entry.label)) {
      remaining_known = values.real(value, entry.label, remaining);
    } else if (kind.has_label(MessageKind::segment, entry.label)) {
      values.position(value, entry.label, p.segment_number);
    } else if (entry.label == "s,t") {
      st = values.real(value, entry.label, p.s) && values.real(value, entry.label, p.t);
    }
  }

  void coordinate(int i, Field entry) {
    std::string_view value = entry.value;
    Vector& point = under == Heading::original ? result.record.original : target;
    const bool read = values.real(value, entry.label, point[i]);
    if (i != 2 || !read) return;
    original = original || under == Heading::original;
    modified = modified || under == Heading::modified;
    recommended = recommended || under == Heading::recommended;
  }

  void segment_nodes(std::string_view line) {
    std::array<std::int64_t, 4> nodes{};
    std::size_t count = 0;
    for (; count < 4 && !trimmed(line).empty(); ++count)
      if (!values.id(line, "penetrated segment nodes", nodes[count])) return;
    if (count < 3) return values.missing("segment's nodes");
    if (count == 3) nodes[3] = nodes[2];
    result.record.segment = nodes;
    segment = true;
  }

  void line(std::string_view text) {
    const auto entry = field(text);
    result.awaits_more = false;
    if (!entry) {
      if (under == Heading::nodes) segment_nodes(text);
      under = text.ends_with("segment nodes:") ? Heading::nodes : Heading::none;
      result.awaits_more = under == Heading::nodes;
      return;
    }
    const int i = axis(entry->label);
    if (i >= 0 && under >= Heading::original) {
      coordinate(i, *entry);
      result.awaits_more = i != 2;
    } else if (const Heading next = heading(entry->label); next != Heading::none) {
      under = next;
      result.awaits_more = true;
    } else {
      under = Heading::none;
      number(*entry);
    }
  }

  void finish() {
    Penetration& p = result.record;
    if (remaining_known) p.contact_distance = p.depth + remaining;
    p.moved_to = modified ? target : p.original;
    p.outcome = recommended ? Outcome::kept : Outcome::reported;
    if (modified && original && p.moved_to != p.original) p.outcome = Outcome::moved;
    if (kind.record == BlockRecord::released) {
      p.kind = PenetrationKind::released;
      p.outcome = Outcome::released;
    }
    p.point = p.original;
    const Vector way = target - p.original;
    if ((modified || recommended) && original && remaining_known && way.norm() > 0)
      p.point -= remaining * way.normalized();
    const int at_bounds = st ? (std::abs(p.s) == 1) + (std::abs(p.t) == 1) : 0;
    p.feature = at_bounds == 0 ? Feature::face : at_bounds == 1 ? Feature::edge : Feature::corner;
    result.complete = result.contact > 0 && p.node > 0;
    if (result.contact == 0) values.missing("interface");
    if (p.node == 0) values.missing("node");
    if (!depth && kind.record == BlockRecord::penetration) values.missing("penetration");
    const bool layout_of_40565 = st || remaining_known || p.segment_number > 0;
    result.awaits_more = result.awaits_more || (layout_of_40565 && !(segment && original));
  }
};

/// The whole number that stands behind a word of the text; 0: none.
std::int64_t number_behind(std::string_view text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at == std::string_view::npos) return 0;
  text.remove_prefix(at + word.size());
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return 0;
  text.remove_prefix(begin);
  return parse_integer(text.substr(0, text.find_first_not_of("0123456789"))).value_or(0);
}

}  // namespace

PenetrationBlock penetration_of(const MessageBlock& block, const MessageKind& kind) {
  PenetrationBlock result;
  PenetrationReader reader{kind, result, Values(block, result.fault)};
  for (std::size_t i = 0; i < block.lines.size(); ++i) {
    reader.values.at(i);
    reader.line(block.lines[i]);
  }
  reader.finish();
  return result;
}

FromBlock<TieFailure> tie_failure_of(const MessageBlock& block, const MessageKind& kind) {
  FromBlock<TieFailure> result;
  Values values(block, result.fault);
  for (std::size_t i = 0; i < block.lines.size(); ++i) {
    const auto entry = field(block.lines[i]);
    if (!entry) continue;
    values.at(i);
    std::string_view value = entry->value;
    if (kind.has_label(MessageKind::contact, entry->label)) {
      values.id(value, entry->label, result.contact);
    } else if (kind.has_label(MessageKind::node, entry->label)) {
      values.id(value, entry->label, result.record.node);
    } else if (kind.has_label(MessageKind::segment, entry->label)) {
      values.position(value, entry->label, result.record.segment_number);
    } else if (kind.has_label(MessageKind::distance, entry->label)) {
      double distance = 0;
      if (values.real(value, entry->label, distance)) result.record.distance = std::abs(distance);
    }
  }
  result.record.reason = kind.reason;
  result.complete = result.contact > 0 && result.record.node > 0;
  if (result.contact == 0) values.missing("interface");
  if (result.record.node == 0) values.missing("node");
  return result;
}

FromBlock<RigidwallPenetration> rigidwall_of(const MessageBlock& block) {
  FromBlock<RigidwallPenetration> result;
  Values values(block, result.fault);
  const std::string text = joined_text(block, 1000);
  result.record.node = number_behind(text, "node ");
  result.record.wall = number_behind(text, "rigidwall ");
  bool depth = false;
  if (const std::size_t equals = text.find("penetration="); equals != std::string::npos) {
    std::string_view value = std::string_view(text).substr(equals + 12);
    depth = values.real(value, "init. penetration", result.record.depth);
  }
  result.complete = result.record.node > 0 && depth;
  if (result.record.node == 0) values.missing("node");
  if (!depth) values.missing("penetration");
  return result;
}

}  // namespace gapcheck::results
