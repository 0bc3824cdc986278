#include "audit/fix/freedoms.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/mesh/rigid_nodes.hpp"
#include "contact/stiffness/element_sizes.hpp"

namespace gapcheck::audit {
namespace {

/// Weights outside this range, from elements without size or with NaN coordinates, are not used.
constexpr double least_weight = 1e-200, greatest_weight = 1e200;

class Weights {
 public:
  Weights(const model::Model& model, const std::vector<std::pair<std::int64_t, double>>& priorities)
      : model_(model), priority_(model.parts.size(), 1.0), weight_(model.mesh.nodes.size(), 0.0) {
    for (const auto& [id, factor] : priorities)
      if (const auto part = model.part_of_id.find(id); part != model.part_of_id.end())
        priority_[part->second.value] = factor;
  }

  std::vector<double> take() {
    const model::Mesh& mesh = model_.mesh;
    const std::vector<Vector>& x = mesh.nodes.x;
    for (std::size_t i = 0; i < mesh.shells.size(); ++i) {
      const auto& n = mesh.shells.nodes[i];
      const std::size_t corners = n[2] == n[3] ? 3 : 4;
      add(std::span(n).first(corners), mesh.shells.part[i], contact::shell_area(n, x) / static_cast<double>(corners));
    }
    add_bricks(mesh.solids);
    add_bricks(mesh.thick_shells);
    for (std::size_t i = 0; i < mesh.beams.size(); ++i) {
      const auto& n = mesh.beams.nodes[i];
      if (n[0] == none<NodeIndex> || n[1] == none<NodeIndex>) continue;
      add(std::span(n), mesh.beams.part[i], (x[n[1].value] - x[n[0].value]).squaredNorm() / 4);
    }
    fill_missing();
    return std::move(weight_);
  }

 private:
  void add(std::span<const NodeIndex> nodes, PartIndex part, double share) {
    const double weight = share * (part == none<PartIndex> ? 1.0 : priority_[part.value]);
    if (!(weight > least_weight && weight < greatest_weight)) return;
    for (const NodeIndex n : nodes)
      if (n != none<NodeIndex>) weight_[n.value] += weight;
  }

  void add_bricks(const model::Elements<8>& elements) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      std::array<NodeIndex, 8> n = elements.nodes[i];
      const double volume = contact::brick_volume(n, model_.mesh.nodes.x);
      std::sort(n.begin(), n.end());
      const auto end = std::unique(n.begin(), n.end());
      add(std::span(n.begin(), end), elements.part[i], std::pow(volume, 2.0 / 3) / 4);
    }
  }

  void fill_missing() {
    double sum = 0;
    std::size_t count = 0;
    for (const double w : weight_) {
      sum += w;
      count += w > 0 ? 1 : 0;
    }
    const double mean = count > 0 ? sum / static_cast<double>(count) : 1;
    for (double& w : weight_)
      if (!(w > 0)) w = mean;
  }

  const model::Model& model_;
  std::vector<double> priority_, weight_;
};

class Holder {
 public:
  Holder(const model::Model& model, Freedoms& freedoms) : model_(model), freedoms_(freedoms) {}

  void lock(const std::vector<Lock>& locks) {
    std::vector<bool> parts(model_.parts.size(), false);
    bool any = false;
    for (const Lock& lock : locks) {
      if (lock.nodes) {
        model_.mesh.nodes.lookup.for_each_in(lock.first, lock.last, [&](std::int64_t, std::uint32_t i) {
          freedoms_.hold(NodeIndex{i}, HoldReason::locked);
          return true;
        });
        continue;
      }
      for (auto part = model_.part_of_id.lower_bound(lock.first);
           part != model_.part_of_id.end() && part->first <= lock.last; ++part)
        any = parts[part->second.value] = true;
    }
    if (any) lock_parts(parts);
  }

  void hold_rigid() {
    const contact::RigidNodes rigid(model_);
    for (std::uint32_t i = 0; i < model_.mesh.nodes.size(); ++i)
      if (rigid.owner(NodeIndex{i})) freedoms_.hold(NodeIndex{i}, HoldReason::rigid);
  }

  void hold_others(std::span<const std::uint8_t> held) {
    for (std::uint32_t i = 0; i < held.size(); ++i)
      if (held[i] != 0) hold(NodeIndex{i}, 7);
  }

  /// One weight for joined nodes; what holds one of them holds all.
  void join() {
    for (const NodeIndex leader : freedoms_.joined.leaders()) {
      Vector weight = Vector::Zero(), free = Vector::Ones();
      bool any = false;
      for (const NodeIndex n : freedoms_.joined.followers(leader)) {
        const Vector& mobility = freedoms_.mobility[n.value];
        free = (mobility.array() > 0).select(free, 0);
        weight += mobility.cwiseMax(1 / greatest_weight).cwiseInverse();
        any = any || freedoms_.reason[n.value] != HoldReason::none;
      }
      for (const NodeIndex n : freedoms_.joined.followers(leader)) {
        freedoms_.mobility[n.value] = free.cwiseQuotient(weight);
        if (any && freedoms_.reason[n.value] == HoldReason::none) freedoms_.reason[n.value] = HoldReason::constrained;
      }
    }
  }

  void hold_boundaries() {
    for (const model::SinglePointConstraint& spc : model_.spcs)
      for_each(spc.nodes, [&](NodeIndex n) { hold(n, spc.system != 0 && (spc.freedoms & 7) != 0 ? 7 : spc.freedoms); });
    for (const model::NodeConstraint& constraint : model_.node_constraints)
      for (const NodeIndex n : constraint.nodes) hold(n, constraint.freedoms);
    for (const model::PrescribedMotion& motion : model_.prescribed_motions)
      if (!motion.rigid) for_each(motion.nodes, [&](NodeIndex n) { hold(n, 7); });
  }

 private:
  template <std::size_t N>
  void lock_elements(const model::Elements<N>& elements, const std::vector<bool>& parts) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (elements.part[i] == none<PartIndex> || !parts[elements.part[i].value]) continue;
      for (const NodeIndex n : elements.nodes[i])
        if (n != none<NodeIndex>) freedoms_.hold(n, HoldReason::locked);
    }
  }

  void lock_parts(const std::vector<bool>& parts) {
    const model::Mesh& mesh = model_.mesh;
    lock_elements(mesh.shells, parts);
    lock_elements(mesh.solids, parts);
    lock_elements(mesh.thick_shells, parts);
    lock_elements(mesh.beams, parts);
    lock_elements(mesh.discrete, parts);
    lock_elements(mesh.masses, parts);
    lock_elements(mesh.particles, parts);
  }

  template <class Visit>
  void for_each(const model::NodeChoice& choice, const Visit& visit) {
    if (!choice.set) {
      if (const auto node = model_.mesh.nodes.lookup.find(choice.id)) visit(NodeIndex{*node});
    } else if (const auto set = model_.sets.nodes.find(choice.id); set != model_.sets.nodes.end()) {
      for (const NodeIndex n : set->second.members) visit(n);
    }
  }

  /// `axes`: bits 0 … 2.
  void hold(NodeIndex node, unsigned axes) {
    if ((axes & 7) == 0) return;
    for (int axis = 0; axis < 3; ++axis)
      if ((axes >> axis & 1) != 0) freedoms_.mobility[node.value][axis] = 0;
    if (freedoms_.reason[node.value] == HoldReason::none) freedoms_.reason[node.value] = HoldReason::constrained;
  }

  const model::Model& model_;
  Freedoms& freedoms_;
};

}  // namespace

void Freedoms::hold(NodeIndex node, HoldReason why) {
  // A node held in all directions holds all that are joined to it: each group is visited once, however often it is
  // held.
  if (reason[node.value] == HoldReason::none || !(mobility[node.value].array() == 0).all())
    for (const NodeIndex n : joined.followers(joined.leader(node))) {
      mobility[n.value].setZero();
      if (reason[n.value] == HoldReason::none) reason[n.value] = HoldReason::constrained;
    }
  mobility[node.value].setZero();
  if (reason[node.value] == HoldReason::none || reason[node.value] == HoldReason::constrained) reason[node.value] = why;
}

Freedoms find_freedoms(const model::Model& model, const std::vector<Lock>& locks,
                       const std::vector<std::pair<std::int64_t, double>>& priorities,
                       std::span<const std::uint8_t> held, JoinedNodes joined) {
  Freedoms freedoms{{}, {}, std::move(joined)};
  for (const double weight : Weights(model, priorities).take())
    freedoms.mobility.emplace_back(Vector::Constant(1 / weight));
  freedoms.reason.assign(freedoms.mobility.size(), HoldReason::none);
  Holder holder(model, freedoms);
  holder.lock(locks);
  holder.hold_rigid();
  holder.hold_boundaries();
  holder.hold_others(held);
  holder.join();
  return freedoms;
}

}  // namespace gapcheck::audit
