#include "solver/state/constraints.hpp"

#include <algorithm>

namespace gapcheck::solver {
namespace {

std::uint64_t key_of(std::size_t node, std::size_t freedom) { return 6 * std::uint64_t{node} + freedom; }

}  // namespace

std::uint32_t Constraints::add_axes(const Matrix& axes) {
  axes_.push_back(axes);
  return static_cast<std::uint32_t>(axes_.size() - 1);
}

void Constraints::set_axes(NodeIndex node, std::uint32_t axes) {
  axes_of_.resize(held_.size(), no_position);
  axes_of_[node.value] = axes;
}

NodeIndex Constraints::first_with_axes() const {
  for (std::uint32_t i = 0; i < axes_of_.size(); ++i)
    if (axes_of_[i] != no_position) return NodeIndex{i};
  return none<NodeIndex>;
}

void Constraints::hold(NodeIndex node, std::uint8_t mask) {
  held_[node.value] |= mask;
  ever_[node.value] |= mask;
}

std::uint32_t Constraints::add(Motion motion) {
  motions_.push_back(std::move(motion));
  return static_cast<std::uint32_t>(motions_.size() - 1);
}

void Constraints::move(NodeIndex node, std::size_t freedom, std::uint32_t motion) {
  ever_[node.value] |= static_cast<std::uint8_t>(1u << freedom);
  moved_.push_back({key_of(node.value, freedom), motion});
}

void Constraints::finish() {
  std::stable_sort(moved_.begin(), moved_.end(), [](const Moved& a, const Moved& b) { return a.key < b.key; });
}

const Motion* Constraints::active(std::size_t node, std::size_t freedom, double time, double dt) const {
  const std::uint64_t key = key_of(node, freedom);
  auto found = std::upper_bound(moved_.begin(), moved_.end(), key,
                                [](std::uint64_t wanted, const Moved& moved) { return wanted < moved.key; });
  while (found != moved_.begin() && (--found)->key == key)
    if (motions_[found->motion].active(time, dt)) return &motions_[found->motion];
  return nullptr;
}

std::vector<const Motion*> Constraints::motions(std::size_t node, std::size_t freedom) const {
  std::vector<const Motion*> list;
  auto found = std::lower_bound(moved_.begin(), moved_.end(), key_of(node, freedom),
                                [](const Moved& moved, std::uint64_t wanted) { return moved.key < wanted; });
  for (; found != moved_.end() && found->key == key_of(node, freedom); ++found)
    list.push_back(&motions_[found->motion]);
  return list;
}

std::uint8_t Constraints::mask(std::size_t node, double time, double dt) const {
  std::uint8_t mask = held_[node];
  const auto moved = static_cast<unsigned>(ever_[node] & ~mask);
  for (std::size_t freedom = 0; freedom < 6 && moved != 0; ++freedom)
    if ((moved >> freedom & 1u) != 0 && active(node, freedom, time, dt) != nullptr)
      mask = static_cast<std::uint8_t>(mask | 1u << freedom);
  return mask;
}

double Constraints::velocity(std::size_t node, std::size_t freedom, double time, double dt) const {
  const Motion* motion = active(node, freedom, time, dt);
  return motion != nullptr ? motion->velocity(time, dt) : 0;
}

}  // namespace gapcheck::solver
