#include <array>
#include <optional>
#include <span>

#include "base/number.hpp"
#include "results/curves/nodout.hpp"
#include "results/text/printed_number.hpp"
#include "results/text/result_text.hpp"

namespace gapcheck::results {
namespace {

constexpr std::size_t value_width = 12;  ///< of one value

using NodeQuantity = Vector NodeState::*;
constexpr std::array<NodeQuantity, 4> translations{&NodeState::displacement, &NodeState::velocity,
                                                   &NodeState::acceleration, &NodeState::position};
constexpr std::array<NodeQuantity, 3> rotations{&NodeState::rotation, &NodeState::angular_velocity,
                                                &NodeState::angular_acceleration};

std::string_view without_blanks_behind(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

/// "n o d a l   p r i n t   o u t   f o r   t i m e  s t e p   24   ( at time 4.8730101E-03 )".
class NodoutReader {
 public:
  NodoutReader(ResultText& file, NodeHistory& history) : file_(file), history_(history) {}

  void line(std::string_view line) {
    const std::string_view text = trimmed(line);
    if (title_.empty()) title_ = text;
    if (text.starts_with("n o d a l")) return heading(text);
    if (text.starts_with("nodal point")) {
      quantities_ = text.find("x-rot") != std::string_view::npos ? std::span<const NodeQuantity>(rotations)
                                                                 : std::span<const NodeQuantity>(translations);
      position_ = 0;
      block_rows_ = 0;
      return;
    }
    if (!in_state_ || quantities_.empty()) return;
    if (text.empty() ? block_rows_ > 0 : text == title_) return end_block();
    if (!text.empty()) row(without_blanks_behind(line));
  }

  /// No rows follow until the next heading of columns.
  void end_block() { quantities_ = {}; }

  void finish() {
    if (rows_ >= rows_before_) return;
    history_.states.pop_back();
    file_.incomplete();
  }

 private:
  void heading(std::string_view text) {
    constexpr std::string_view step = "s t e p", at_time = "( at time";
    quantities_ = {};
    const std::size_t at_step = text.find(step), at = text.find(at_time);
    std::string_view time_text = at == std::string_view::npos ? std::string_view{} : text.substr(at + at_time.size());
    std::string_view cycle_text = at_step == std::string_view::npos ? time_text : text.substr(at_step + step.size());
    const double time = file_.take(time_text);
    in_state_ = time == time;
    if (!in_state_) return;
    const std::int64_t cycle = std::max<std::int64_t>(take_integer(cycle_text).value_or(0), 0);
    // Translations and rotations of one state have a heading each.
    if (!history_.states.empty() && history_.states.back().time == time &&
        history_.states.back().cycle == static_cast<std::uint64_t>(cycle))
      return;
    history_.states.push_back({static_cast<std::uint64_t>(cycle), time, {}});
    rows_before_ = rows_;
    rows_ = 0;
  }

  void row(std::string_view line) {
    const std::size_t values = 3 * quantities_.size(), width = value_width * values;
    if (line.size() <= width) return file_.unreadable();
    // Right-aligned: the last value ends the line, and the text before the first one is the node.
    const auto node = parse_integer(trimmed(line.substr(0, line.size() - width)));
    if (!node) return file_.unreadable();
    NodeState& state = node_at(*node);
    std::size_t at = line.size() - width;
    for (const NodeQuantity quantity : quantities_)
      for (int axis = 0; axis < 3; ++axis, at += value_width) {
        std::string_view field = trimmed(line.substr(at, value_width));
        (state.*quantity)[axis] = file_.take(field);
      }
    ++rows_;
    ++block_rows_;
  }

  /// Both blocks have the same nodes in the same order.
  NodeState& node_at(std::int64_t id) {
    std::vector<NodeState>& nodes = history_.states.back().nodes;
    if (position_ < nodes.size() && nodes[position_].node == id) return nodes[position_++];
    position_ = nodes.size() + 1;
    nodes.emplace_back().node = id;
    return nodes.back();
  }

  ResultText& file_;
  NodeHistory& history_;
  std::span<const NodeQuantity> quantities_;  ///< of the block; empty: outside
  bool in_state_ = false;
  std::size_t position_ = 0;  ///< of the next row among the state's nodes
  std::size_t rows_ = 0, rows_before_ = 0, block_rows_ = 0;
  std::string_view title_;  ///< the file's first line; it recurs where files were concatenated
};

}  // namespace

NodeHistory read_nodout(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  NodeHistory history;
  ResultText file(text, name, diagnostics);
  NodoutReader reader(file, history);
  for (; !file.done(); file.advance())
    if (file.take_legend(history.titles))
      reader.end_block();
    else
      reader.line(file.line());
  reader.finish();
  file.finish();
  return history;
}

}  // namespace gapcheck::results
