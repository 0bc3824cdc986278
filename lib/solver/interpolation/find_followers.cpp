#include "solver/interpolation/find_followers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "solver/contact/contact_method.hpp"
#include "solver/interpolation/follower_groups.hpp"
#include "solver/interpolation/motion_fit.hpp"
#include "solver/tie/tie.hpp"
#include "solver/tie/tie_nodes.hpp"

namespace gapcheck::solver {
namespace {

constexpr unsigned translation_bits = 7, rotation_bits = 56;

/// Of a dense system: degrees of freedom that follow, and these times those of the independent nodes.
constexpr Eigen::Index most_rows = 3000;
constexpr std::size_t most_coefficients = 20'000'000;

/// Bits 0 … 5 of digits 1 … 6; nothing for other digits.
std::optional<unsigned> freedoms_of_digits(std::int64_t digits) {
  unsigned mask = 0;
  for (; digits > 0; digits /= 10) {
    const std::int64_t digit = digits % 10;
    if (digit < 1 || digit > 6) return std::nullopt;
    mask |= 1u << (digit - 1);
  }
  return digits < 0 || mask == 0 ? std::nullopt : std::optional(mask);
}

/// Builds the followers of one deck; keeps the first failure.
class FollowerFinder {
 public:
  FollowerFinder(const model::Model& model, const Structure& structure, Diagnostics& diagnostics)
      : model_(model), structure_(structure), diagnostics_(diagnostics) {}

  void find() {
    for (const model::Interpolation& one : model_.interpolations) {
      card_ = &one;
      if (!check_card()) return;
      Follower follower;
      follower.id = one.id;
      follower.place = one.place;
      follower.ends_run = one.deletion == 1;
      if (!add_dependent(follower) || !add_nodes(follower) || !check_motion(follower)) return;
      followers_.push_back(std::move(follower));
    }
    check_chains();
    check_size();
  }

  /// Nodes that constraints tie cannot follow or be followed.
  void check_ties(contact::SurfaceStore& surfaces, const contact::InitialState& initial) {
    if (!status_.ok() || followers_.empty()) return;
    for (const model::Contact& contact : model_.contacts)
      if (choose_method(contact).method == ContactMethod::constraint)
        return fail(
            Failure::Kind::not_calculated, contact.place,
            fmt::format("contact {} (*{}), which acts by constraints, is not calculated in one run with it; use "
                        "a contact by springs",
                        contact.id.value, contact.written));
    std::set<std::uint32_t> used;
    for (const Follower& follower : followers_) {
      used.insert(follower.node);
      used.insert(follower.nodes.begin(), follower.nodes.end());
    }
    for (const Tie& tie : tie_list(model_, surfaces, initial, structure_, true)) {
      std::vector<NodeIndex> nodes(tie.point.nodes.begin(), tie.point.nodes.end());
      nodes.push_back(tie.node);
      for (const NodeIndex node : nodes)
        if (used.count(node.value) > 0)
          return fail(Failure::Kind::not_calculated, model_.contact(tie.contact).place,
                      fmt::format("node {} takes part in it and is tied by constraints in contact {}; tie by an OFFSET "
                                  "form",
                                  structure_.node_id[node.value], model_.contact(tie.contact).id.value));
    }
    // A spring without a mass at one of its ends has no frequency that the step could follow.
    for (const Tie& tie : tie_list(model_, surfaces, initial, structure_, false))
      if (dependent_.count(tie.node.value) > 0 && !has_mass(structure_.state.mass[tie.node.value]))
        return fail(Failure::Kind::zero_mass, model_.contact(tie.contact).place,
                    fmt::format("dependent node {} has no mass and contact {} ties it; give it one",
                                structure_.node_id[tie.node.value], model_.contact(tie.contact).id.value));
  }

  [[nodiscard]] SolverResult<std::vector<Follower>> take() {
    if (!status_.ok()) return status_.error();
    return std::move(followers_);
  }

 private:
  void fail(Failure::Kind kind, model::Place place, std::string_view why) {
    if (status_.ok()) status_ = Failure{kind, fmt::format("*{} {}: {}", card_->keyword, card_->id, why), place};
  }
  void warn(std::string_view why) {
    diagnostics_.warning(model_.file(card_->place), card_->place.line,
                         fmt::format("*{} {}: {}", card_->keyword, card_->id, why));
  }
  [[nodiscard]] std::int64_t id(std::uint32_t node) const { return structure_.node_id[node]; }

  bool check_card() {
    const auto wrong = [&](std::string_view why) { fail(Failure::Kind::contradiction, card_->place, why); };
    if (card_->by_set != 0 && card_->by_set != 1)
      wrong(fmt::format("ITYP = {} has no meaning; use 0 for nodes, 1 for node sets", card_->by_set));
    if (card_->deletion != 1 && card_->deletion != 2)
      wrong(fmt::format("IDNSW = {} has no meaning; use 0, 1 or 2", card_->deletion));
    if (card_->independents.empty()) wrong("it has no independent nodes; give them");
    return status_.ok();
  }

  [[nodiscard]] std::optional<Matrix> axes(std::int64_t system, model::Place place) {
    if (system == 0) return Matrix(Matrix::Identity());
    const auto found = model_.systems.find(system);
    if (found != model_.systems.end() && found->second.fault.empty()) return Matrix(found->second.axes);
    fail(Failure::Kind::not_calculated, place,
         fmt::format("directions in the local system {} are not calculated: {}", system,
                     found == model_.systems.end() ? "its axes are not known" : found->second.fault));
    return std::nullopt;
  }

  /// Nodes outside rigid bodies, whose conditions are in global axes.
  bool check_node(std::uint32_t node, model::Place place) {
    if (structure_.rigid.holds(node))
      fail(Failure::Kind::not_calculated, place,
           fmt::format("node {} belongs to a rigid body or weld; name nodes outside it", id(node)));
    else if (structure_.constraints.axes(node) != nullptr)
      fail(Failure::Kind::not_calculated, place,
           fmt::format("node {} has conditions in local axes; give them in the global axes", id(node)));
    return status_.ok();
  }

  bool add_dependent(Follower& follower) {
    const model::Place place = card_->place;
    const auto wanted = freedoms_of_digits(card_->freedoms);
    if (!wanted)
      fail(Failure::Kind::contradiction, place,
           fmt::format("DDOF = {}: the digits 1 to 6 name degrees of freedom", card_->freedoms));
    const auto node = model_.mesh.nodes.lookup.find(card_->dependent);
    if (!node)
      fail(Failure::Kind::unknown_reference, place,
           fmt::format("dependent node {} is not defined; define it", card_->dependent));
    const std::optional<Matrix> directions = axes(card_->system, place);
    if (!status_.ok()) return false;
    follower.node = *node;
    if (!check_node(follower.node, place)) return false;
    follower.axes.resize(6, 0);
    for (int k = 0; k < 6; ++k) {
      if ((*wanted >> k & 1u) == 0) continue;
      follower.axes.conservativeResize(6, follower.axes.cols() + 1);
      follower.axes.rightCols<1>().setZero();
      follower.axes.rightCols<1>().segment<3>(k < 3 ? 0 : 3) = directions->col(k % 3);
    }
    const unsigned held = structure_.constraints.mask(follower.node);
    for (int k = 0; k < 6; ++k)
      if ((held >> k & 1u) != 0 && !follower.axes.row(k).isZero(1e-12))
        fail(Failure::Kind::contradiction, place,
             fmt::format("dependent node {} is held or moved in a direction that DDOF names; remove one of both",
                         card_->dependent));
    if (!dependent_.insert(follower.node).second)
      fail(Failure::Kind::contradiction, place,
           fmt::format("node {} is the dependent one of two interpolations", card_->dependent));
    return status_.ok();
  }

  /// The nodes of one card; nothing after a failure.
  [[nodiscard]] std::vector<NodeIndex> nodes_of(const model::Interpolation::Independent& card) {
    if (card.nodes.set) {
      const auto set = model_.sets.nodes.find(card.nodes.id);
      if (set != model_.sets.nodes.end() && !set->second.members.empty()) return set->second.members;
    } else if (const auto node = model_.mesh.nodes.lookup.find(card.nodes.id)) {
      return {NodeIndex{*node}};
    }
    fail(Failure::Kind::unknown_reference, card.place,
         fmt::format("independent node{} {} is not defined{}", card.nodes.set ? " set" : "", card.nodes.id,
                     card.nodes.set ? " or empty; give its nodes" : "; define it"));
    return {};
  }

  bool add_nodes(Follower& follower) {
    std::map<std::uint32_t, Matrix> weight_of;
    std::size_t without_rotations = 0;
    for (const model::Interpolation::Independent& card : card_->independents) {
      const auto freedoms = freedoms_of_digits(card.freedoms);
      if (!freedoms)
        fail(Failure::Kind::contradiction, card.place,
             fmt::format("IDOF = {}: the digits 1 to 6 name degrees of freedom", card.freedoms));
      for (const double weight : card.weights)
        if (!(weight > 0) || !std::isfinite(weight))
          fail(Failure::Kind::contradiction, card.place,
               fmt::format("the weight {:g} is not above 0; leave nodes out that do not count", weight));
      const std::optional<Matrix> directions = axes(card.system, card.place);
      const std::vector<NodeIndex> nodes = nodes_of(card);
      if (!status_.ok()) return false;
      Matrix weight = Matrix::Zero();
      for (int k = 0; k < 3; ++k)
        if ((*freedoms >> k & 1u) != 0)
          weight += card.weights[static_cast<std::size_t>(k)] * directions->col(k) * directions->col(k).transpose();
      for (const NodeIndex node : nodes) {
        if (node.value == follower.node)
          fail(Failure::Kind::contradiction, card.place, fmt::format("node {} follows itself", card_->dependent));
        if (!check_independent(node.value, *freedoms, card)) return false;
        without_rotations += (*freedoms & rotation_bits) != 0;
        weight_of.try_emplace(node.value, Matrix::Zero()).first->second += weight;
      }
    }
    for (const auto& [node, weight] : weight_of) {
      follower.nodes.push_back(node);
      follower.weights.push_back(weight);
    }
    if (without_rotations > 0)
      warn(fmt::format("{} independent nodes have no rotations: of IDOF only the digits 1 to 3 count for them",
                       without_rotations));
    return status_.ok();
  }

  bool check_independent(std::uint32_t node, unsigned freedoms, const model::Interpolation::Independent& card) {
    if (!check_node(node, card.place)) return false;
    if ((freedoms & rotation_bits) != 0 && structure_.state.inertia[node] > 0)
      fail(Failure::Kind::not_calculated, card.place,
           fmt::format("IDOF = {}: rotations of independent nodes (node {}) are not calculated, since it is not "
                       "published how their weights stand to those of translations; set IDOF to 123",
                       card.freedoms, id(node)));
    if (!has_mass(structure_.state.mass[node]) &&
        (structure_.constraints.held(node) & translation_bits) != translation_bits)
      fail(Failure::Kind::zero_mass, card.place,
           fmt::format("independent node {} has no mass; give it one or hold it", id(node)));
    return status_.ok();
  }

  /// The independent nodes must give what DDOF names; the initial velocity is theirs.
  bool check_motion(const Follower& follower) {
    std::vector<Vector> places;
    for (const std::uint32_t node : follower.nodes) places.push_back(structure_.state.x[node]);
    const MotionFit fit(follower.weights, places);
    const Vector& point = structure_.state.x[follower.node];
    for (Eigen::Index k = 0; k < follower.axes.cols(); ++k)
      if (!fit.determines(follower.axes.col(k), point))
        fail(Failure::Kind::contradiction, card_->place,
             fmt::format("the independent nodes do not give the {} of node {}: they are in line, too few, or IDOF "
                         "leaves directions out; add nodes off their line or shorten DDOF",
                         follower.axes.col(k).head<3>().isZero(0) ? "rotation" : "motion", card_->dependent));
    Twist motion = Twist::Zero(), given;
    for (std::size_t i = 0; i < follower.nodes.size(); ++i)
      motion += fit.share(i, point) * structure_.state.v[follower.nodes[i]];
    given << structure_.state.v[follower.node], structure_.state.w[follower.node];
    const auto gap = (follower.axes.transpose() * (given - motion)).norm();
    if ((follower.axes.transpose() * given).norm() > 0 && gap > 1e-9 * given.norm())
      warn(fmt::format("the initial velocity of node {} is replaced by that of the independent nodes",
                       card_->dependent));
    return status_.ok();
  }

  void check_chains() {
    if (!status_.ok()) return;
    std::map<std::uint32_t, const Follower*> follows;
    for (const Follower& follower : followers_) follows.emplace(follower.node, &follower);
    for (std::size_t f = 0; f < followers_.size(); ++f)
      for (const std::uint32_t node : followers_[f].nodes)
        if (const auto found = follows.find(node); found != follows.end()) {
          card_ = &model_.interpolations[f];
          return fail(Failure::Kind::not_calculated, card_->place,
                      fmt::format("independent node {} is the dependent one of interpolation {}; name that one's "
                                  "independent nodes",
                                  id(node), found->second->id));
        }
  }

  void check_size() {
    if (!status_.ok()) return;
    for (const FollowerGroup& group : group_followers(followers_)) {
      if (group.rows <= most_rows && 3 * group.nodes.size() <= most_coefficients / static_cast<std::size_t>(group.rows))
        continue;
      card_ = &model_.interpolations[group.followers[0]];
      return fail(Failure::Kind::not_calculated, card_->place,
                  fmt::format("{} interpolations share their {} independent nodes, which are too many to solve for "
                              "together; let fewer of them share nodes",
                              group.followers.size(), group.nodes.size()));
    }
  }

  const model::Model& model_;
  const Structure& structure_;
  Diagnostics& diagnostics_;
  const model::Interpolation* card_ = nullptr;
  std::vector<Follower> followers_;
  std::set<std::uint32_t> dependent_;  ///< their nodes
  SolverStatus status_;
};

}  // namespace

SolverResult<std::vector<Follower>> find_followers(const model::Model& model, contact::SurfaceStore& surfaces,
                                                   const contact::InitialState& initial, const Structure& structure,
                                                   Diagnostics& diagnostics) {
  FollowerFinder finder(model, structure, diagnostics);
  finder.find();
  finder.check_ties(surfaces, initial);
  auto found = finder.take();
  if (found && !found.value().empty() && !model.rigid_walls.empty())
    diagnostics.warning("", 0,
                        fmt::format("rigid walls do not stop the {} nodes that follow others; let independent nodes "
                                    "meet the wall",
                                    found.value().size()));
  return found;
}

}  // namespace gapcheck::solver
