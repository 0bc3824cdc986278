#include "audit/fix/node_lines.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace gapcheck::audit {
namespace {

/// Components of a move below this share of it come from rounding.
constexpr double component_rounding = 1e-9;
/// Placements that flatten space cannot be undone.
constexpr double flat = 1e-12;

keyword::CardLayout node_layout() {
  keyword::CardLayout layout = keyword::card_layout("NODE", "card1");
  layout.fields.resize(4);
  return layout;
}

bool invertible(const keyword::Transform& transform) {
  if (!std::isfinite(transform.length_factor) || transform.length_factor == 0) return false;
  if (!transform.places) return true;
  const double size = transform.matrix.norm();
  return std::abs(transform.matrix.determinant()) > flat * size * size * size;
}

/// A move in the model as one in the coordinates of the file.
Vector in_file(const keyword::Transform& transform, const Vector& move) {
  const Vector local = (transform.places ? Vector(transform.matrix.inverse() * move) : move) / transform.length_factor;
  return (local.array().abs() < component_rounding * local.norm()).select(0, local);
}

}  // namespace

NodeLines::NodeLines(const keyword::Deck& deck, const model::Model& model, const std::vector<Vector>& x)
    : deck_(deck),
      model_(model),
      x_(x),
      layout_(node_layout()),
      blocks_(deck.files().size()),
      read_twice_(deck.files().size()) {
  for (const keyword::Block& block : deck.blocks()) blocks_[block.file.value].push_back(&block);
  std::map<const char*, std::uint32_t> first;
  for (std::uint32_t f = 0; f < deck.files().size(); ++f) {
    const std::string_view bytes = deck.file(FileIndex{f}).bytes;
    if (bytes.empty()) continue;
    const auto [found, added] = first.emplace(bytes.data(), f);
    if (!added) read_twice_[f] = read_twice_[found->second] = true;
  }
  find_duplicates();
}

void NodeLines::find_duplicates() {
  for (const model::Fault& fault : model_.faults) {
    if (fault.kind != model::Fault::Kind::duplicate_id || fault.place.file.value >= blocks_.size()) continue;
    Place again{block_at(fault.place.file, fault.place.line), {}, fault.place.line};
    if (again.block == nullptr) continue;
    again.line = lines(fault.place.file).line(again.number);
    again_.emplace(card(again, again.line).integer(0), true);
  }
}

const keyword::LineIndex& NodeLines::lines(FileIndex file) {
  const auto found = lines_.find(file.value);
  return found != lines_.end() ? found->second : lines_.emplace(file.value, deck_.file(file).bytes).first->second;
}

/// The block of *NODE that has the line; nullptr if there is none.
const keyword::Block* NodeLines::block_at(FileIndex file, std::uint32_t line) const {
  const auto& list = blocks_[file.value];
  const auto behind = std::upper_bound(list.begin(), list.end(), line,
                                       [](std::uint32_t l, const keyword::Block* block) { return l < block->line; });
  if (behind == list.begin()) return nullptr;
  return (*(behind - 1))->name == "NODE" ? *(behind - 1) : nullptr;
}

keyword::Card NodeLines::card(const Place& place, std::string_view line) {
  return {deck_, *place.block, layout_, line, place.number, ignored_};
}

NodeLines::Place NodeLines::place(NodeIndex node) {
  const model::Nodes& nodes = model_.mesh.nodes;
  const FileIndex file = nodes.origins.file(node.value);
  if (file.value >= blocks_.size()) return {};
  const std::uint32_t number = nodes.line[node.value];
  return {block_at(file, number), lines(file).line(number), number};
}

Status NodeLines::check(NodeIndex node) {
  const Place at = place(node);
  if (at.block == nullptr) return plain_error("its line was not found");
  if (read_twice_[at.block->file.value]) return plain_error("its file is included more than once");
  if (again_.contains(model_.mesh.nodes.id[node.value])) return plain_error("it is defined more than once");
  if (!invertible(deck_.transform(at.block->transform)))
    return plain_error("the transformation of its include cannot be undone");
  const keyword::Card line = card(at, at.line);
  for (std::size_t field = 1; field < 4; ++field)
    if (Status status = keyword::check_replaceable(line, field); !status.ok()) return status;
  return {};
}

keyword::LineEdit NodeLines::edit(NodeIndex node, const Vector& to) {
  const Place at = place(node);
  keyword::LineEdit edit{at.number, std::string(at.line)};
  if (at.block == nullptr) return edit;
  const Vector move = to - x_[node.value];
  if (!move.allFinite()) return edit;
  const Vector local = in_file(deck_.transform(at.block->transform), move);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (local[static_cast<int>(axis)] == 0) continue;
    const keyword::Card line = card(at, edit.text);
    edit.text = keyword::with_number(line, axis + 1, line.real(axis + 1) + local[static_cast<int>(axis)]);
  }
  return edit;
}

Vector NodeLines::written(NodeIndex node, const Vector& to) {
  const keyword::LineEdit line = edit(node, to);
  const Place at = place(node);
  if (at.block == nullptr || line.text == at.line) return x_[node.value];
  const keyword::Card card = this->card(at, line.text);
  const keyword::Transform& transform = deck_.transform(at.block->transform);
  return transform.apply(transform.length_factor * Vector(card.real(1), card.real(2), card.real(3)));
}

Status check_geometry(const keyword::Deck& deck) {
  constexpr std::array read{"NODE_TRANSFORM", "PART_MOVE"};
  constexpr std::array unread{"NODE_MERGE",     "NODE_REPLICATE",        "ELEMENT_GENERATE", "PART_MOVE_",
                              "PART_DUPLICATE", "PART_STACKED_ELEMENTS", "NODE_TRANSFORM_"};
  for (const keyword::Block& block : deck.blocks()) {
    const auto begins = [&](std::string_view name) { return block.name.starts_with(name); };
    std::string_view why;
    if (std::any_of(unread.begin(), unread.end(), begins))
      why = "is not read, so that the nodes are not where they run";
    else if (std::any_of(read.begin(), read.end(), begins))
      why = "moves nodes after their lines are read";
    if (!why.empty())
      return Diagnostic{Severity::error, deck.file(block.file).path, block.line,
                        fmt::format("*{} {}; write its effect into the coordinates first", block.name, why)};
  }
  if (deck.counters().missing_includes > 0)
    return Diagnostic{Severity::error, "", 0, "includes are missing, and with them what nodes could run into"};
  return {};
}

Result<MovedDeck> move_deck(const keyword::Deck& deck, const model::Model& model, const std::vector<Vector>& x) {
  if (const Status status = check_geometry(deck); !status.ok()) return status.error();
  const model::Nodes& nodes = model.mesh.nodes;
  NodeLines lines(deck, model, nodes.x);
  MovedDeck moved;
  std::map<std::uint32_t, std::vector<keyword::LineEdit>> by_file;
  for (const NodeIndex n : positions<NodeIndex>(nodes.size())) {
    if (x[n.value] == nodes.x[n.value]) continue;
    const std::uint32_t file = nodes.origins.file(n.value).value;
    if (const Status status = lines.check(n); !status.ok())
      return Diagnostic{
          Severity::error, deck.files()[file].path, nodes.line[n.value],
          fmt::format("node {} cannot be written where it starts: {}", nodes.id[n.value], status.error().message)};
    moved.rounding = std::max(moved.rounding, (lines.written(n, x[n.value]) - x[n.value]).norm());
    // A move below the last digit of its line changes nothing.
    keyword::LineEdit edit = lines.edit(n, x[n.value]);
    by_file[file].push_back(std::move(edit));
  }
  for (auto& [file, edits] : by_file) {
    std::ranges::sort(edits, {}, &keyword::LineEdit::line);
    moved.nodes += edits.size();
    moved.files.push_back({FileIndex{file}, std::move(edits)});
  }
  return moved;
}

}  // namespace gapcheck::audit
