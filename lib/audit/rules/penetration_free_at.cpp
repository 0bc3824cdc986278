#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "audit/contact_thickness.hpp"
#include "audit/records_of.hpp"
#include "audit/rules.hpp"
#include "contact/outcome.hpp"
#include "contact/pair.hpp"
#include "contact/record_pair.hpp"

namespace gapcheck::audit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The workshop's check: a deck should be free of penetrations at about this SST, in millimetres.
constexpr double recommended_millimetres = 0.5;

/// SST and MST give these their thickness: shells, beams, and nodes without any element.
bool takes_card(ThicknessRule rule) {
  return rule != ThicknessRule::none && rule != ThicknessRule::part_contact && rule != ThicknessRule::solid_coating;
}

bool solid_part(const model::Model& model, PartIndex index) {
  if (index == none<PartIndex> || !model.part(index).section) return false;
  const model::SectionKind kind = model.sections[*model.part(index).section].kind;
  return kind == model::SectionKind::solid || kind == model::SectionKind::thick_shell;
}

/// What SST and MST would change in the surfaces of a contact.
struct Reach {
  bool fixed = false;         ///< something keeps its thickness whatever SST is: OPTT, SLDTHK
  std::array<bool, 2> segments{};  ///< whether any segment of side A, B takes it
  double thinnest = infinity; ///< present thickness of what takes SST
};

Reach reach_of_card(const model::Model& model, const contact::ContactSurfaces& surfaces) {
  Reach reach;
  const auto add = [&](ThicknessRule rule, double half) {
    if (rule == ThicknessRule::part_contact || rule == ThicknessRule::solid_coating) reach.fixed = true;
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
      if (nodes.rule[i] != ThicknessRule::none || !solid_part(model, nodes.part[i])) add(nodes.rule[i], nodes.half[i]);
  }
  return reach;
}

/// What the records of one contact say about SST.
struct Bound {
  double sst = infinity;                 ///< no listed node is nearer to any segment
  const Penetration* closest = nullptr;  ///< the record that sets it
  const Penetration* stuck = nullptr;    ///< deepest node that no SST sets free
  std::uint64_t stuck_count = 0, count = 0;
};

Bound bound(const model::Model& model, const contact::ContactSurfaces& surfaces, const Reach& reach,
            std::span<const Penetration> records) {
  const auto segments_take = [&](const Penetration& p) {
    if (!surfaces.two_sided() || reach.segments[0] == reach.segments[1]) return reach.segments[0];
    const auto pair = find_pair(surfaces, model.mesh, p);
    return !pair || reach.segments[pair->segment_on_b];
  };
  // Contact distance as a multiple of SST: half from a node that takes it, half from a segment.
  const auto share = [&](const Penetration& p) {
    bool node = takes_card(p.node_rule);
    if (p.node_rule == ThicknessRule::none) {
      const auto part = model.part_of_id.find(p.part);
      node = part == model.part_of_id.end() || !solid_part(model, part->second);
    }
    return (node ? 0.5 : 0.0) + (segments_take(p) ? 0.5 : 0.0);
  };
  const auto sst = [&](const Penetration& p) { return p.remaining() / share(p); };
  constexpr std::uint64_t free = 0, stuck = 1;
  const auto found = worst_by_key(records.size(), [&](std::size_t i) {
    const Penetration& p = records[i];
    if (!listed_by_solver(p.kind)) return Weighed{};
    const double on_it = contact::default_tolerance(p.contact_distance, p.original.cwiseAbs().maxCoeff());
    if (!(p.remaining() > on_it) || share(p) == 0) return Weighed{stuck, p.depth};
    return Weighed{free, 1 / sst(p)};
  });
  Bound result;
  for (const Worst& w : found) {
    const Penetration& p = records[w.item];
    result.count += w.count;
    if (w.key == free)
      result.closest = &p, result.sst = sst(p);
    else
      result.stuck = &p, result.stuck_count = w.count;
  }
  return result;
}

/// Four digits, rounded down: what is printed must still be free.
double rounded_down(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / unit * (1 + 1e-12)) * unit;
}

std::string segment_words(const Penetration& p) {
  return p.element != 0 ? fmt::format("element {}", p.element) : fmt::format("segment {}", p.segment_number);
}

class FreeAt {
 public:
  FreeAt(const RuleInfo& rule, Context& context, Report& report)
      : rule_(rule), context_(context), model_(context.model()), report_(report) {}

  void run() {
    bool moved = false;  // some earlier contact has moved nodes
    for (const std::uint32_t i : contacts_with_thickness(rule_, context_)) moved = first_look(i, moved) || moved;
    if (!open_.empty()) look_again();
    if (fixed_ > 0)
      context_.skipped(rule_, fmt::format("{} contacts with OPTT or SLDTHK, which SST does not replace", fixed_));
  }

 private:
  /// Takes SST from the records of the initialisation where they are all that is needed; true if nodes were moved.
  bool first_look(std::uint32_t i, bool moved) {
    const auto records = records_of(context_.initial(), i);
    if (records.empty()) return false;
    const contact::ContactSurfaces& surfaces = context_.surfaces(i);
    const Reach reach = reach_of_card(model_, surfaces);
    const bool moves = contact::outcome(surfaces.settings) == Outcome::moved;
    if (reach.fixed) {
      ++fixed_;
      return moves;
    }
    const Bound b = bound(model_, surfaces, reach, records);
    const bool two_way = surfaces.type.treatment == contact::Treatment::two_way;
    if (b.count == 0) return false;  // notes only
    // With this SST some pairs would come nearer to each other than they are now, or were looked at where others had
    // been moved already.
    const bool incomplete = b.sst > reach.thinnest || (moves && two_way) || moved;
    if (b.stuck == nullptr && incomplete)
      open_.push_back({i, reach, b});
    else
      add(i, b, b.sst, b.count);
    return moves;
  }

  /// One more search with the SST found so far shows what else is as near.
  void look_again() {
    std::vector<contact::ThicknessChange> changes(model_.contacts.size());
    std::vector<std::uint32_t> chosen;
    for (const Open& open : open_) {
      changes[open.contact].card = open.bound.sst;
      chosen.push_back(open.contact);
    }
    contact::SurfaceStore surfaces(model_, std::move(changes));
    const contact::InitialState state = context_.initial_if(surfaces, chosen);
    context_.count_other(surfaces);
    for (const Open& open : open_) {
      Bound b = bound(model_, context_.surfaces(open.contact), open.reach, records_of(state, open.contact));
      if (b.count == 0) b = open.bound;
      add(open.contact, b, std::min(open.bound.sst, b.sst), open.bound.count);
    }
  }

  void add(std::uint32_t i, const Bound& b, double sst, std::uint64_t penetrations) {
    const model::Contact& contact = model_.contacts[i];
    const Penetration* p = b.stuck != nullptr ? b.stuck : b.closest;
    Finding f = finding_at(rule_, context_, contact, b.stuck != nullptr ? stuck_words(b, penetrations) : words(contact, b, sst));
    f.count = penetrations;
    if (p != nullptr) {
      f.node = p->node;
      f.part = p->part;
      f.element = p->element;
      f.element_part = p->element_part;
      f.point = p->original;
    }
    report_.findings.push_back(std::move(f));
  }

  [[nodiscard]] std::string words(const model::Contact& contact, const Bound& b, double sst) const {
    const bool single = contact::classify(contact).treatment == contact::Treatment::single_surface;
    std::string text = fmt::format("free of penetrations with {} <= {:.4g}", single ? "SST" : "SST = MST", rounded_down(sst));
    if (b.closest != nullptr)
      text += fmt::format("; the closest is node {}, {:.4g} from {}", b.closest->node, b.closest->remaining(),
                          segment_words(*b.closest));
    const double recommended = recommended_millimetres * context_.options().millimetre;
    if (sst < recommended)
      text += fmt::format("; below the {:.4g} ({} mm) at which a deck should be free", recommended, recommended_millimetres);
    return text;
  }

  static std::string stuck_words(const Bound& b, std::uint64_t penetrations) {
    const Penetration& p = *b.stuck;
    return fmt::format("no SST makes it free: {} of {} penetrating nodes lie on the segment itself or behind it, node {} {:.4g} "
                       "behind {}; move them",
                       b.stuck_count, penetrations, p.node, std::max(0.0, -p.remaining()), segment_words(p));
  }

  struct Open {
    std::uint32_t contact;
    Reach reach;
    Bound bound;
  };
  const RuleInfo& rule_;
  Context& context_;
  const model::Model& model_;
  Report& report_;
  std::vector<Open> open_;
  std::size_t fixed_ = 0;
};

void run(const RuleInfo& rule, Context& context, Report& report) {
  FreeAt(rule, context, report).run();
}

}  // namespace

const Rule penetration_free_at{
    {"GC308", "penetration-free-at", Severity::note, "the largest SST with which a contact has no initial penetrations"},
    run};

}  // namespace gapcheck::audit
