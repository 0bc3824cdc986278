#include "solver/loss/remedies.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "contact/pair/release.hpp"
#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::solver {
namespace {

/// A larger SOFSCL comes near what the step bears.
constexpr double largest_sofscl = 0.5;
constexpr int remedy_halvings = 100;

/// The stiffness of an impact's spring with a remedy.
using ChangedStiffness = std::function<double(const Impact&)>;

/// What the remedies should raise.
const std::optional<double>& margin_of(const Impact& impact) { return impact.margin ? impact.margin : impact.alone; }

/// The least margin of a row if the springs of its contact change.
class ChangedMargin {
 public:
  ChangedMargin(std::span<const Impact> all, std::span<const std::size_t> row) : all_(all), row_(row) {
    for (const std::size_t i : row) groups_[all[i].group];
    for (const Impact& impact : all)
      if (const auto group = groups_.find(impact.group); group != groups_.end()) group->second.push_back(&impact);
  }

  [[nodiscard]] double operator()(const ChangedStiffness& changed) const {
    std::map<std::size_t, double> factor;  // by group: of the summed stiffness
    for (const auto& [group, members] : groups_) {
      double before = 0, after = 0;
      for (const Impact* const impact : members) {
        if (!impact->first) continue;
        before += impact->spring.stiffness;
        after += impact->pass.contact == all_[row_.front()].pass.contact ? changed(*impact) : impact->spring.stiffness;
      }
      factor[group] = before > 0 ? after / before : 1;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : row_) {
      const Impact& impact = all_[i];
      if (!margin_of(impact)) continue;
      const double of_spring = impact.margin ? factor[impact.group] : changed(impact) / impact.spring.stiffness;
      least = std::min(least, *margin_of(impact) * std::sqrt(of_spring));
    }
    return least;
  }

 private:
  std::span<const Impact> all_;
  std::span<const std::size_t> row_;
  std::map<std::size_t, std::vector<const Impact*>> groups_;
};

double with_soft_1(const Impact& impact, double sofscl, double step) {
  const double soft = contact::soft_1_stiffness(impact.spring.node_mass, impact.spring.segment_mass, step);
  return contact::soft_1_spring(impact.spring.stiffness, sofscl, soft);
}

const model::Contact& card_of(const Impact& impact) { return impact.pass.pass->pairs().scene().contact; }

/// The least of [low, high] with which the margin is the wanted one; it rises with it.
std::optional<double> bisect(double low, double high, const std::function<double(double)>& margin) {
  if (!(margin(high) >= wanted_margin)) return std::nullopt;
  for (int i = 0; i < remedy_halvings; ++i) {
    const double middle = low + (high - low) / 2;
    (margin(middle) >= wanted_margin ? high : low) = middle;
  }
  return high;
}

/// The contact thickness of the nodes' side; of a single surface that of both.
std::optional<double> thickness_of_nodes(const Impact& impact) {
  const contact::PairScene& scene = impact.pass.pass->pairs().scene();
  if (scene.model.controls.penopt == 5) return std::nullopt;  // it makes springs softer
  contact::ReleasePair pair = contact::release_pair(scene, impact.meeting.slot, impact.meeting.segment);
  const bool single = scene.type.treatment == contact::Treatment::single_surface;
  const auto depth = [&](double thickness) {
    pair.node_thickness = thickness;
    if (single) pair.segment_thickness = thickness;
    return contact::release_depth(scene.contact, scene.type, scene.settings, scene.model.controls, pair);
  };
  const double wanted = wanted_margin * impact.release / *margin_of(impact);
  const double slope = depth(1) - depth(0);
  if (!(slope > 0) || !std::isfinite(slope)) return std::nullopt;
  const double thickness = (wanted - depth(0)) / slope;
  // Behind an oriented segment there is no more room than before.
  if (scene.oriented(impact.meeting.segment) &&
      wanted > thickness / 2 + scene.segments.half[impact.meeting.segment.value] + scene.behind(impact.meeting.segment))
    return std::nullopt;
  // A thicker contact must not begin with a penetration.
  const double other = single ? thickness / 2 : scene.segments.half[impact.meeting.segment.value];
  const double apart = impact.contact_distance + impact.speed() * impact.time();
  if (!(thickness / 2 + other < apart)) return std::nullopt;
  return thickness;
}

}  // namespace

void find_remedies(std::span<const Impact> all, std::span<const std::size_t> row, double step,
                   ExpectedContact& result) {
  if (result.crossing > 0 && result.in_step && *result.in_step > 0)
    result.step = step / (wanted_margin * *result.in_step);
  const std::optional<double>& known = result.margin ? result.margin : result.alone;
  if (!known || *known >= wanted_margin) return;
  const ChangedMargin margin(all, row);
  const Impact& any = all[row.front()];
  const model::Contact& card = card_of(any);
  const double spring_step = any.pass.interface->stiffness_step();
  if (card.soft == 0 || card.soft == 1)
    result.sofscl = bisect(card.soft == 1 ? card.sofscl : 0, largest_sofscl, [&](double sofscl) {
      return margin([&](const Impact& impact) { return with_soft_1(impact, sofscl, spring_step); });
    });
  if (card.soft == 1 && !(card.dtstif > 0))
    if (const auto factor = bisect(1, 1e3, [&](double faster) {
          return margin([&](const Impact& impact) { return with_soft_1(impact, card.sofscl, spring_step / faster); });
        }))
      result.step = std::min(result.step.value_or(step), step / *factor);
  std::optional<double> thickness = 0;
  for (const std::size_t i : row) {
    if (!margin_of(all[i])) continue;
    const std::optional<double> one = thickness_of_nodes(all[i]);
    thickness = one && thickness ? std::optional(std::max(*one, *thickness)) : std::nullopt;
    if (!thickness) break;
  }
  if (!thickness || !(*thickness > 0)) return;
  result.thickness = thickness;
  result.thickness_card = any.pass.pass->pairs().exchanged() ? "MST" : "SST";
}

}  // namespace gapcheck::solver
