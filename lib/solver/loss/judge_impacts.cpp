#include "solver/loss/judge_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "records/expected_contact.hpp"
#include "solver/loss/deepest_nodes.hpp"
#include "solver/loss/impact_depth.hpp"
#include "solver/loss/spring_share.hpp"

namespace gapcheck::solver {
namespace {

using Kind = ConnectedBodies::Kind;

/// Shares up to which directions, speeds, depths and torques are one.
constexpr double alike_share = 1e-3;
/// How far beyond the quarter of a period other impacts disturb one.
constexpr double meanwhile = 1.2;

/// The impacts between two bodies.
struct ImpactGroup {
  std::uint32_t a = 0, b = 0;
  std::vector<std::size_t> members;  ///< positions, by time
  double begin = 0, end = 0;         ///< of the impact: a quarter of its period
};

double square(double x) { return x * x; }

/// Judges the impacts between two bodies.
class GroupJudge {
 public:
  GroupJudge(const ImpactScene& scene, std::vector<Impact>& impacts, ImpactGroup& group)
      : scene_(scene), bodies_(scene.bodies), impacts_(impacts), group_(group) {
    const Impact& first = impacts_[group.members.front()];
    normal_ = first.meeting.contact.normal;
    speed_ = first.speed();
    group_.begin = first.time();
    for (const std::size_t i : group.members) {
      const Impact& impact = impacts_[i];
      deepest_release_ = std::max(deepest_release_, impact.release);
      const bool of_a = bodies_.of(impact.node) == group.a;
      (of_a ? on_a_ : on_b_).push_back(impact.node);
      auto& others = of_a ? on_b_ : on_a_;
      others.insert(others.end(), impact.corners.begin(), impact.corners.end());
    }
    kind_a_ = bodies_.kind(on_a_);
    kind_b_ = group.a == group.b ? kind_a_ : bodies_.kind(on_b_);
    one_mass_ = group.a != group.b && kind_a_ != Kind::elastic && kind_b_ != Kind::elastic;
    set_mobilities();
    if (one_mass_ || !moves_as_one()) return;
    one_mass_ = true;
    set_mobilities();
  }

  /// How long it takes, as far as that is known.
  void set_end() { group_.end = group_.begin + quarter_; }
  [[nodiscard]] bool fixed(std::uint32_t body) const { return (body == group_.a ? kind_a_ : kind_b_) == Kind::fixed; }

  /// `disturbed`: why others act on the two as well; empty: they do not.
  void judge(std::string_view disturbed) {
    judge_all(disturbed.empty() ? why_not_exact() : disturbed, !disturbed.empty());
  }
  /// It is not exact after all.
  void withdraw(std::string_view reason) {
    for (const std::size_t i : group_.members) {
      Impact& impact = impacts_[i];
      impact.margin.reset();
      impact.low.reset();
      impact.high.reset();
    }
    judge_all(reason, false);
  }

 private:
  void judge_all(std::string_view reason, bool disturbed) {
    for (const std::size_t i : group_.members) {
      Impact& impact = impacts_[i];
      impact.reason = reason;
      if (kind_a_ == Kind::fixed && kind_b_ == Kind::fixed) continue;
      if (!std::isfinite(impact.release)) continue;
      if (impact.speed() * scene_.step > impact.way_of_one_step()) {
        impact.reason = crossing_reason;
        continue;
      }
      judge_one(impact, disturbed);
    }
    if (!disturbed && !reason.empty()) bound_from_above();
  }

  void set_mobilities() {
    const double of_a = mobility(kind_a_, on_a_), of_b = mobility(kind_b_, on_b_);
    for (const std::size_t i : group_.members) {
      Impact& impact = impacts_[i];
      const bool node_of_a = bodies_.of(impact.node) == group_.a;
      const Kind own = node_of_a ? kind_a_ : kind_b_;
      // A rigid body that meets something elastic is one mass too; the elastic one yields, which only helps.
      impact.together = one_mass_ || own == Kind::rigid || own == Kind::point;
      if (one_mass_)
        impact.mobility = of_a + of_b;
      else if (impact.together)
        impact.mobility = node_of_a ? of_a : of_b;
      else if (impact.spring.node_mass > 0)
        impact.mobility = 1 / impact.spring.node_mass;
    }
    // The first node alone takes longest; what meets within a small share of that meets with it.
    const Impact& begin = impacts_[group_.members.front()];
    quarter_ = quarter_of(begin, begin.spring.stiffness);
    first_stiffness_ = 0;
    const double same_time = alike_share * alike_share * quarter_;
    for (const std::size_t i : group_.members) {
      impacts_[i].first = impacts_[i].time() - group_.begin <= same_time;
      if (impacts_[i].first) first_stiffness_ += impacts_[i].spring.stiffness;
    }
    if (begin.together) quarter_ = quarter_of(begin, first_stiffness_);
    if (!begin.together)
      for (const std::size_t i : group_.members)
        quarter_ = std::max(quarter_, quarter_of(impacts_[i], impacts_[i].spring.stiffness));
  }

  [[nodiscard]] static double quarter_of(const Impact& impact, double stiffness) {
    const double rate = stiffness * impact.mobility;
    return rate > 0 ? std::numbers::pi / 2 / std::sqrt(rate) : 0;
  }

  /// Whether a body that deforms meets something fixed with all of its mass at one time, all nodes with springs in the
  /// ratio of their masses: then they slow down together, and it does not deform.
  [[nodiscard]] bool moves_as_one() const {
    if ((kind_a_ == Kind::fixed) == (kind_b_ == Kind::fixed) || group_.a == group_.b) return false;
    const std::uint32_t body = kind_a_ == Kind::fixed ? group_.b : group_.a;
    std::map<NodeIndex, double> springs;
    for (const std::size_t i : group_.members) {
      if (!impacts_[i].first || bodies_.of(impacts_[i].node) != body) return false;
      springs[impacts_[i].node] += impacts_[i].spring.stiffness;
    }
    double mass = 0;
    for (const auto& [node, stiffness] : springs) mass += scene_.state.mass[node.value];
    for (const auto& [node, stiffness] : springs)
      if (bodies_.rigid(node) != nullptr ||
          !(std::abs(stiffness * mass - first_stiffness_ * scene_.state.mass[node.value]) <=
            alike_share * first_stiffness_ * scene_.state.mass[node.value]))
        return false;
    return bodies_.mass(body) <= mass * (1 + 1e-9) &&
           bodies_.flies_freely(body, start_velocity(springs.begin()->first));
  }

  /// Of one mass: 0 where it is fixed.
  [[nodiscard]] double mobility(Kind kind, const std::vector<NodeIndex>& nodes) const {
    if (one_mass_ && kind == Kind::elastic) return 1 / bodies_.mass(bodies_.of(nodes.front()));
    return kind == Kind::fixed || kind == Kind::elastic || nodes.empty() ? 0 : bodies_.mobility(nodes.front(), normal_);
  }

  /// Why the impact is not that of one mass on springs that act at one time; empty: it is.
  [[nodiscard]] std::string_view why_not_exact() const {
    if (kind_a_ == Kind::fixed && kind_b_ == Kind::fixed) return "both parts follow prescribed motions";
    if (group_.a == group_.b) return "both are of one body";
    if (!one_mass_) return "parts deform";
    for (const std::size_t i : group_.members) {
      const Impact& impact = impacts_[i];
      // Nodes higher up press too where the first ones go as deep.
      if (!impact.first && speed_ * (impact.time() - group_.begin) <= meanwhile * depth())
        return "its nodes do not meet at one time";
      if (!impact.first) continue;
      const TimeOfContact& contact = impact.meeting.contact;
      if (!(std::abs(contact.normal.dot(normal_)) >= 1 - square(alike_share))) return "its nodes meet different slopes";
      if (!(std::abs(contact.speed() - speed_) <= alike_share * speed_)) return "its nodes have different speeds";
      const Vector along = contact.velocity - contact.velocity.dot(contact.normal) * contact.normal;
      if (!(along.norm() <= alike_share * speed_)) return "it slides meanwhile";
      if (impact.pass.pass->pairs().scene().contact.vdc > 0) return "the contact has damping (VDC)";
      if (!keeps_its_speed(impact)) return "a prescribed motion changes meanwhile";
    }
    for (const bool of_b : {false, true})
      if ((of_b ? kind_b_ : kind_a_) == Kind::rigid && turns(of_b ? group_.b : group_.a)) return "it turns meanwhile";
    return {};
  }

  /// It meets before the first ones have been released, or shown that they are not.
  [[nodiscard]] bool comes_in_time(const Impact& impact) const {
    return speed_ * (impact.time() - group_.begin) <= flight_of_release * deepest_release_;
  }

  /// Of one mass.
  [[nodiscard]] double depth() const { return speed_ * quarter_ * 2 / std::numbers::pi; }

  [[nodiscard]] bool keeps_its_speed(const Impact& impact) const {
    const auto keeps = [&](NodeIndex node) {
      const Vector at = scene_.flight.velocity(node, group_.begin),
                   then = scene_.flight.velocity(node, group_.begin + meanwhile * quarter_);
      return (then - at).norm() <= alike_share * speed_;
    };
    return keeps(impact.node) && std::ranges::all_of(impact.corners, keeps);
  }

  /// Whether a rigid body turns, or the springs turn it.
  [[nodiscard]] bool turns(std::uint32_t body) const {
    const std::vector<NodeIndex>& nodes = body == group_.a ? on_a_ : on_b_;
    const BodyState& state = *bodies_.rigid(nodes.front());
    Vector torque = Vector::Zero();
    double reach = 0, force = 0;
    for (const std::size_t i : group_.members) {
      const Impact& impact = impacts_[i];
      if (!impact.first) continue;
      Vector place = Vector::Zero();
      if (bodies_.of(impact.node) == body) {
        place = scene_.state.x[impact.node.value] + scene_.flight.way(impact.node, group_.begin);
      } else {
        for (std::size_t c = 0; c < 4; ++c)
          place += impact.meeting.contact.weights[c] *
                   (scene_.state.x[impact.corners[c].value] + scene_.flight.way(impact.corners[c], group_.begin));
      }
      const Vector arm = place - state.center - state.velocity * group_.begin;
      torque += impact.spring.stiffness * arm.cross(normal_);
      force += impact.spring.stiffness;
      reach = std::max(reach, arm.norm());
    }
    if (state.spin.norm() * reach > alike_share * alike_share * speed_) return true;
    const double turned = (state.turn_response * torque).norm() * reach;
    return turned > alike_share * force * std::max(bodies_.mobility(nodes.front(), normal_), 0.0);
  }

  void judge_one(Impact& impact, bool disturbed) {
    if (impact.reason.empty()) return judge_exactly(impact);
    const bool of_a = bodies_.of(impact.node) == group_.a;
    const Kind own = of_a ? kind_a_ : kind_b_;
    if (own != Kind::rigid && own != Kind::fixed && rate_of(impact) > 0)
      impact.alone = impact.release * rate_of(impact) / impact.speed();
    if (!disturbed) bound_by_energy(impact);
  }

  void judge_exactly(Impact& impact) {
    if (!impact.first) return;  // the others have stopped it before
    const auto range = depth_of_one_mass(impact.speed(), impact.mobility, first_stiffness_, scene_.step);
    if (!range) {
      impact.reason = "the step is too large for the springs";
      return;
    }
    impact.margin = impact.release * std::sqrt(first_stiffness_ * impact.mobility) / impact.speed();
    impact.low = impact.release / range->most;
    impact.high = impact.release / range->least;
  }

  /// Of a node and its spring alone.
  [[nodiscard]] static double rate_of(const Impact& impact) {
    return std::sqrt(impact.spring.stiffness * impact.mobility);
  }

  void bound_by_energy(Impact& impact) {
    if (!energy_known_) {
      energy_known_ = true;
      energy_ = bodies_.energy(group_.a, group_.b);
      std::vector<const Impact*> in_time;
      for (const std::size_t i : group_.members)
        if (comes_in_time(impacts_[i])) in_time.push_back(&impacts_[i]);
      share_ = share_of_springs(scene_, in_time, normal_);
    }
    if (!energy_) return;
    if (const auto depth = depth_of_energy(*energy_, impact.spring.stiffness, share_); depth && *depth > 0)
      impact.low = impact.release / *depth;
  }

  /// Speeds with which something is released for sure. Of a body that flies freely onto a fixed one.
  void bound_from_above() {
    if (kind_b_ == Kind::fixed ? kind_a_ != Kind::elastic : kind_a_ != Kind::fixed || kind_b_ != Kind::elastic) return;
    const std::uint32_t body = kind_b_ == Kind::fixed ? group_.a : group_.b;
    if (!of_one_row()) return;
    std::vector<PressedNode> first, all;
    bool all_first = true;
    double mass = 0;
    std::vector<NodeIndex> nodes;
    for (const std::size_t i : group_.members) {
      const Impact& impact = impacts_[i];
      const TimeOfContact& contact = impact.meeting.contact;
      if (!comes_in_time(impact)) break;
      if (!(std::abs(contact.normal.dot(normal_)) >= 1 - square(alike_share)) || !keeps_its_speed(impact) ||
          !(std::abs(contact.speed() - speed_) <= alike_share * speed_) ||
          !(contact.velocity.norm() <= (1 + square(alike_share)) * contact.speed()) ||
          impact.pass.pass->pairs().scene().contact.vdc > 0)
        return;
      // The springs of corners that fixed nodes press on count for the force alone.
      all.push_back({impact.spring.stiffness, impact.release});
      all_first = all_first && impact.first;
      if (!impact.first || bodies_.of(impact.node) != body) continue;
      first.push_back(all.back());
      nodes.push_back(impact.node);
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const NodeIndex node : nodes) {
      if (bodies_.rigid(node) != nullptr) return;
      mass += scene_.state.mass[node.value];
    }
    if (!(mass > 0) || !bodies_.flies_freely(body, start_velocity(nodes.front()))) return;
    double limit = speed_of_release(first, all, mass);
    if (all_first && bodies_.mass(body) <= mass * (1 + 1e-9))
      limit = std::min(limit, speed_of_release_of_sheet(all, mass, scene_.step));
    if (!std::isfinite(limit)) return;
    for (const std::size_t i : group_.members)
      if (impacts_[i].alone) impacts_[i].high = limit / speed_;
  }

  /// Which of several contacts lets go first is not known.
  [[nodiscard]] bool of_one_row() const {
    const Impact& first = impacts_[group_.members.front()];
    return std::ranges::all_of(group_.members, [&](std::size_t i) {
      return impacts_[i].pass.contact == first.pass.contact && impacts_[i].part == first.part &&
             impacts_[i].other_part == first.other_part;
    });
  }

  [[nodiscard]] Vector start_velocity(NodeIndex node) const { return scene_.flight.velocity(node, 0); }

  const ImpactScene& scene_;
  const ConnectedBodies& bodies_;
  std::vector<Impact>& impacts_;
  ImpactGroup& group_;
  std::vector<NodeIndex> on_a_, on_b_;  ///< nodes that press or are pressed
  Kind kind_a_ = Kind::elastic, kind_b_ = Kind::elastic;
  bool one_mass_ = false;
  Vector normal_ = Vector::Zero();
  double speed_ = 0, quarter_ = 0, first_stiffness_ = 0, deepest_release_ = 0;
  bool energy_known_ = false;
  std::optional<double> energy_;
  double share_ = 0;
};

}  // namespace

double Impact::way_of_one_step() const {
  constexpr double share_of_distance = 0.8;
  const double way =
      contact_distance > 0 ? share_of_distance * contact_distance : std::numeric_limits<double>::infinity();
  return std::min(way, release);
}

void judge_impacts(const ImpactScene& scene, std::vector<Impact>& impacts) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, ImpactGroup> by_bodies;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const std::uint32_t a = scene.bodies.of(impacts[i].node), b = scene.bodies.of(impacts[i].corners[0]);
    ImpactGroup& group = by_bodies[std::minmax(a, b)];
    std::tie(group.a, group.b) = std::minmax(a, b);
    group.members.push_back(i);
  }
  std::vector<GroupJudge> judges;
  std::vector<const ImpactGroup*> groups;
  for (auto& [bodies, group] : by_bodies) {
    std::ranges::stable_sort(group.members, {}, [&](std::size_t i) { return impacts[i].time(); });
    for (const std::size_t i : group.members) impacts[i].group = groups.size();
    judges.emplace_back(scene, impacts, group).set_end();
    groups.push_back(&group);
  }
  // Bodies that move freely, with the impacts that they take part in.
  std::map<std::uint32_t, std::vector<std::size_t>> of_body;
  std::vector<std::string_view> disturbed(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::uint32_t body : {groups[g]->a, groups[g]->b})
      if (!judges[g].fixed(body)) {
        of_body[body].push_back(g);
        if (scene.busy.contains(body)) disturbed[g] = "one of the two is in contact from the start on";
      }
  for (const auto& [body, list] : of_body) {
    double before = std::numeric_limits<double>::infinity(), second = before;  // the two that begin first
    std::size_t earliest = list.front();
    for (const std::size_t g : list) {
      if (groups[g]->begin < before) {
        second = std::exchange(before, groups[g]->begin);
        earliest = g;
      } else {
        second = std::min(second, groups[g]->begin);
      }
    }
    for (const std::size_t g : list) {
      const double other = g == earliest ? second : before;
      const double takes = groups[g]->end - groups[g]->begin;
      if (other <= groups[g]->begin + meanwhile * takes && disturbed[g].empty())
        disturbed[g] = "one of the two meets something else by then";
    }
  }
  for (std::size_t g = 0; g < groups.size(); ++g) judges[g].judge(disturbed[g]);
  for (const std::size_t g : groups_that_leave_faces(scene, impacts))
    judges[g].withdraw("its nodes come as deep as other faces");
}

}  // namespace gapcheck::solver
