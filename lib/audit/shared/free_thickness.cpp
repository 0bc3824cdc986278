#include "audit/shared/free_thickness.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "audit/shared/records_of.hpp"
#include "audit/shared/worst_by_key.hpp"
#include "contact/definition/outcome.hpp"
#include "contact/pair/pair.hpp"
#include "contact/pair/record_pair.hpp"

namespace gapcheck::audit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// SST and MST give these their thickness once OPTT is 0: shells, beams, and nodes without any element.
bool takes_card(ThicknessRule rule) { return rule != ThicknessRule::none && rule != ThicknessRule::solid_coating; }

/// What SST and MST would change in the surfaces of a contact.
struct Reach {
  bool optt = false;               ///< something has its thickness from OPTT
  std::array<bool, 2> segments{};  ///< whether any segment of side A, B uses it
  double thinnest = infinity;      ///< present thickness of what SST replaces
};

Reach reach_of_card(const model::Model& model, const contact::ContactSurfaces& surfaces) {
  Reach reach;
  const auto add = [&](ThicknessRule rule, double half) {
    if (rule == ThicknessRule::part_contact) reach.optt = true;
    reach.thinnest = std::min(reach.thinnest, 2 * half);
  };
  for (const bool b : {false, true}) {
    const contact::ContactSide& side = b ? surfaces.b : surfaces.a;
    const contact::Segments& s = side.selection.segments;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s.kind[i] == contact::SegmentKind::solid) continue;
      reach.segments[b] = true;
      add(s.rule[i], s.half[i]);
    }
    const contact::TrackedNodes& nodes = side.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (takes_card(nodes.rule[i]) || (nodes.rule[i] == ThicknessRule::none && !solid_part(model, nodes.part[i])))
        add(nodes.rule[i], nodes.half[i]);
  }
  return reach;
}

FreeThickness bound(const model::Model& model, const contact::ContactSurfaces& surfaces, const Reach& reach,
                    double coating, std::span<const Penetration> records) {
  const auto segments_take = [&](const Penetration& p) {
    if (!surfaces.two_sided() || reach.segments[0] == reach.segments[1]) return reach.segments[0];
    const auto pair = find_pair(surfaces, model.mesh, p);
    return !pair || reach.segments[pair->segment_on_b];
  };
  return free_thickness(records, [&](const Penetration& p) {
    DistanceRule distance;
    const auto coat = [&](ThicknessRule rule) { return rule == ThicknessRule::solid_coating; };
    if (takes_card(p.node_rule) || (p.node_rule == ThicknessRule::none && !solid_part(model, p.part)))
      distance.share += 0.5;
    if (!coat(p.segment_rule) && segments_take(p)) distance.share += 0.5;
    distance.fixed = (coat(p.node_rule) ? 0.5 * coating : 0) + (coat(p.segment_rule) ? 0.5 * coating : 0);
    return distance;
  });
}

class CardSearch {
 public:
  CardSearch(const FreeCardScene& scene, const contact::InitialState& state) : scene_(scene), state_(state) {}

  /// Takes SST from the records of the initialisation if they suffice.
  void first_look(ContactIndex i) {
    const auto records = records_of(state_, i);
    if (records.empty()) return;
    const contact::ContactSurfaces& surfaces = scene_.surfaces(i);
    const Reach reach = reach_of_card(scene_.model, surfaces);
    const bool moves = contact::outcome(surfaces.settings) == Outcome::moved;
    const bool moved_before = moved_;
    const FreeThickness b = bound(scene_.model, surfaces, reach, coating(i), records);
    if (b.count() == 0) return;  // notes only
    moved_ = moved_ || moves;
    const bool two_way = surfaces.type.treatment == contact::Treatment::two_way;
    // With this SST some pairs would come nearer than they are now, or were checked after others had been moved.
    const bool incomplete = b.value > reach.thinnest || (moves && two_way) || moved_before;
    const FreeCard card{i, b, b.value, reach.optt, b.count()};
    if (b.stuck_count + b.coated_count == 0 && incomplete)
      open_.push_back({card, reach});
    else
      found_.push_back(card);
  }

  /// One more search with the SST found so far shows what else is as near.
  void look_again() {
    if (open_.empty()) return;
    std::vector<contact::ThicknessChange> changes(scene_.model.contacts.size());
    std::vector<ContactIndex> chosen;
    for (const Open& open : open_) {
      changes[open.card.contact.value] = {open.card.optt, open.card.value};
      chosen.push_back(open.card.contact);
    }
    const contact::InitialState state = scene_.search(std::move(changes), chosen);
    for (Open& open : open_) {
      FreeCard& card = open.card;
      const FreeThickness b = bound(scene_.model, scene_.surfaces(card.contact), open.reach, coating(card.contact),
                                    records_of(state, card.contact));
      card.value = std::min(card.value, b.value);
      if (b.count() > 0) card.bound = b;
      found_.push_back(card);
    }
  }

  [[nodiscard]] std::vector<FreeCard> take() { return std::move(found_); }

 private:
  struct Open {
    FreeCard card;
    Reach reach;
  };
  [[nodiscard]] double coating(ContactIndex i) const { return std::abs(scene_.model.contact(i).sldthk); }

  const FreeCardScene& scene_;
  const contact::InitialState& state_;
  std::vector<Open> open_;
  std::vector<FreeCard> found_;
  bool moved_ = false;  ///< some earlier contact has moved nodes
};

}  // namespace

FreeThickness free_thickness(std::span<const Penetration> records,
                             const std::function<DistanceRule(const Penetration&)>& distance) {
  const auto thickness = [](const Penetration& p, const DistanceRule& d) {
    return (p.remaining() - d.fixed) / d.share;
  };
  constexpr std::uint64_t free = 0, stuck = 1, coated = 2;
  const auto found = worst_by_key(records.size(), [&](std::size_t i) {
    const Penetration& p = records[i];
    if (!listed_by_solver(p.kind)) return Weighed{};
    const double on_it = contact::default_tolerance(p.contact_distance, p.original.cwiseAbs().maxCoeff());
    const DistanceRule d = distance(p);
    if (!(p.remaining() > on_it) || (d.share == 0 && d.fixed == 0)) return Weighed{stuck, p.depth};
    if (!(p.remaining() > d.fixed + on_it) || d.share == 0) return Weighed{coated, d.fixed / p.remaining()};
    return Weighed{free, 1 / thickness(p, d)};
  });
  FreeThickness result;
  for (const Worst& w : found) {
    const Penetration& p = records[w.item];
    if (w.key == free)
      result.closest = p, result.value = thickness(p, distance(p)), result.free_count = w.count;
    else if (w.key == coated)
      result.coated = p, result.coat_factor = p.remaining() / distance(p).fixed, result.coated_count = w.count;
    else
      result.stuck = p, result.stuck_count = w.count;
  }
  return result;
}

bool solid_part(const model::Model& model, PartIndex index) {
  if (index == none<PartIndex> || !model.part(index).section) return false;
  const model::SectionKind kind = model.sections[*model.part(index).section].kind;
  return kind == model::SectionKind::solid || kind == model::SectionKind::thick_shell;
}

bool solid_part(const model::Model& model, std::int64_t id) {
  const auto part = model.part_of_id.find(id);
  return part != model.part_of_id.end() && solid_part(model, part->second);
}

namespace {

/// Four digits. `whole`: of a number between 1,000 and 10,000.
double four_digits(double value, double (*whole)(double)) {
  // A quotient by a power of ten is the number that the decimal reads back as.
  const double places = 3 - std::floor(std::log10(value));
  const double unit = std::pow(10, std::abs(places));
  return places > 0 ? whole(value * unit) / unit : whole(value / unit) * unit;
}

}  // namespace

double rounded_down(double value) {
  return four_digits(value, [](double digits) { return std::floor(digits * (1 + 1e-12)); });
}

double rounded_up(double value) {
  return four_digits(value, [](double digits) { return std::ceil(digits * (1 - 1e-10)); });
}

std::vector<FreeCard> free_cards(const FreeCardScene& scene, std::span<const ContactIndex> contacts,
                                 const contact::InitialState& state) {
  CardSearch search(scene, state);
  for (const ContactIndex contact : contacts) search.first_look(contact);
  search.look_again();
  return search.take();
}

}  // namespace gapcheck::audit
