#include "results/log/message_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

/// Reads the values of one block and remembers the first invalid one.
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

  void position(std::string_view& text, std::string_view label, std::uint32_t& value) {
    std::int64_t number = 0;
    if (!id(text, label, number)) return;
    if (number <= std::numeric_limits<std::uint32_t>::max()) value = static_cast<std::uint32_t>(number);
  }

  void missing(const char* what) {
    if (fault_.what.empty()) fault_ = {block_.line, fmt::format("message {} does not say the {}", block_.code, what)};
  }

 private:
  bool unreadable(std::string_view text, std::string_view label) {
    if (fault_.what.empty())
      fault_ = {block_.line_of(line_), fmt::format("the value of '{}' is not a number: '{}'", label.substr(0, 40),
                                                   trimmed(text).substr(0, 40))};
    return false;
  }

  const MessageBlock& block_;
  BlockFault& fault_;
  std::size_t line_ = 0;
};

/// The coordinates that a block lists: three lines below a heading.
enum class Heading : std::uint8_t { none, nodes, original, modified, recommended };

Heading heading_of(std::string_view label) {
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

/// The ids of a line, at most four. Ids that fill their columns touch each other: columns of 8 or 10, right-aligned.
std::vector<std::string_view> ids_in(std::string_view line) {
  constexpr std::size_t longest_id = 10;
  std::vector<std::string_view> ids;
  bool touching = false;
  for (std::string_view rest = trimmed(line); !rest.empty() && ids.size() < 4; rest = trimmed(rest)) {
    ids.push_back(rest.substr(0, rest.find_first_of(" \t")));
    touching = touching || ids.back().size() > longest_id;
    rest.remove_prefix(ids.back().size());
  }
  for (const std::size_t width : {std::size_t{8}, std::size_t{10}}) {
    if (!touching || line.size() <= 3 * width || line.size() > 4 * width) continue;
    std::vector<std::string_view> columns;
    for (std::size_t end = line.size() - 3 * width, begin = 0; begin < line.size(); begin = end, end += width)
      columns.push_back(trimmed(line.substr(begin, end - begin)));
    // A blank between digits of one column: these are not columns but longer ids.
    const bool whole = std::all_of(columns.begin(), columns.end(), [](std::string_view id) {
      return !id.empty() && id.find_first_of(" \t") == std::string_view::npos;
    });
    if (whole) return columns;
  }
  return ids;
}

struct PenetrationReader {
  const MessageKind& kind;
  PenetrationBlock& result;
  Values values;
  Heading under = Heading::none;
  Vector target = Vector::Zero();
  double remaining = 0;
  std::size_t segment_ids = 0, coordinates_on_segment = 0;
  std::string_view unfinished = {};  ///< label of a field whose numbers are on the next line
  bool depth = false, remaining_known = false, segment = false, original = false, modified = false, recommended = false;

  void number(const Field& entry) {
    Penetration& p = result.record;
    std::string_view value = entry.value;
    unfinished = value.empty() ? entry.label : std::string_view{};
    if (entry.label == "s,t") return on_segment(value);
    const auto what = kind.label_of(entry.label);
    if (!what || value.empty()) return;
    switch (*what) {
      case MessageKind::contact:
        return void(values.id(value, entry.label, result.contact));
      case MessageKind::node:
        return void(values.id(value, entry.label, p.node));
      case MessageKind::segment:
        return values.position(value, entry.label, p.segment_number);
      case MessageKind::distance:
        depth = values.real(value, entry.label, p.depth);
        p.depth = std::abs(p.depth);
        return;
      case MessageKind::remaining:
        remaining_known = values.real(value, entry.label, remaining);
        return;
      case MessageKind::label_count:
        return;
    }
  }

  /// s and t, if the line has them.
  void on_segment(std::string_view value) {
    for (double* target_value : {&result.record.s, &result.record.t}) {
      if (target_value == &result.record.s && coordinates_on_segment > 0) continue;
      if (trimmed(value).empty()) break;
      if (!values.real(value, "s,t", *target_value)) return;
      ++coordinates_on_segment;
    }
    unfinished = coordinates_on_segment < 2 ? "s,t" : "";
  }

  void coordinate(int i, const Field& entry) {
    std::string_view value = entry.value;
    Vector& point = under == Heading::original ? result.record.original : target;
    const bool read = values.real(value, entry.label, point[i]);
    if (i != 2 || !read) return;
    original = original || under == Heading::original;
    modified = modified || under == Heading::modified;
    recommended = recommended || under == Heading::recommended;
  }

  /// Three ids are a triangle, if no fourth follows.
  void segment_nodes(std::string_view line) {
    auto& nodes = result.record.segment;
    for (std::string_view text : ids_in(line)) {
      if (segment_ids == 4) return;
      if (!values.id(text, "penetrated segment nodes", nodes[segment_ids])) {
        under = Heading::none;
        return;
      }
      ++segment_ids;
    }
    segment = segment_ids >= 3;
    if (segment_ids == 3) nodes[3] = nodes[2];
    if (segment_ids == 4) under = Heading::none;
  }

  void text_line(std::string_view text) {
    if (text.ends_with("segment nodes:")) {
      under = Heading::nodes;
    } else if (under == Heading::nodes) {
      segment_nodes(text);
    } else if (!unfinished.empty()) {
      number({unfinished, text});
    } else {
      under = Heading::none;
    }
    result.awaits_more = (under == Heading::nodes && !segment) || !unfinished.empty();
  }

  void line(std::string_view text) {
    const auto entry = field(text);
    if (!entry) return text_line(text);
    if (under == Heading::nodes && segment_ids > 0 && !segment) values.missing("segment's nodes");
    result.awaits_more = false;
    const int i = axis(entry->label);
    if (i >= 0 && under >= Heading::original) {
      coordinate(i, *entry);
      result.awaits_more = i != 2;
    } else if (const Heading next = heading_of(entry->label); next != Heading::none) {
      under = next;
      result.awaits_more = true;
    } else {
      under = Heading::none;
      const bool alone = entry->value.find('=') == std::string_view::npos;
      if (alone)
        number(*entry);
      else
        for (const Field& one : fields(text)) number(one);
      result.awaits_more = !unfinished.empty();
    }
  }

  void finish() {
    Penetration& p = result.record;
    if (depth && remaining_known) p.contact_distance = p.depth + remaining;
    const bool st = coordinates_on_segment == 2;
    if (!st) p.s = p.t = std::numeric_limits<double>::quiet_NaN();
    p.moved_to = modified || recommended ? target : p.original;
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

/// The whole number after a word of the text; 0: none.
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
  const auto take = [&](const Field& entry) {
    std::string_view value = entry.value;
    const auto what = kind.label_of(entry.label);
    if (!what) return;
    double distance = 0;
    switch (*what) {
      case MessageKind::contact:
        return void(values.id(value, entry.label, result.contact));
      case MessageKind::node:
        return void(values.id(value, entry.label, result.record.node));
      case MessageKind::segment:
        return values.position(value, entry.label, result.record.segment_number);
      case MessageKind::distance:
        if (values.real(value, entry.label, distance)) result.record.distance = std::abs(distance);
        return;
      case MessageKind::remaining:
      case MessageKind::label_count:
        return;
    }
  };
  std::string_view unfinished;
  for (std::size_t i = 0; i < block.lines.size(); ++i) {
    values.at(i);
    const std::vector<Field> list = fields(block.lines[i]);
    if (list.empty() && !unfinished.empty()) take({unfinished, block.lines[i]});
    unfinished = {};
    for (const Field& entry : list) {
      if (entry.value.empty())
        unfinished = entry.label;
      else
        take(entry);
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
