#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_set>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"
#include "audit/shared/records_of.hpp"
#include "audit/shared_results.hpp"
#include "contact/pair/pair.hpp"
#include "contact/pair/record_pair.hpp"

namespace gapcheck::audit::rule::thickness_override {
namespace {

/// An override is far from the elements' own thickness beyond this factor, either way.
constexpr double far_factor = 2;

/// What gave an override: 0 SST, 1 MST, 2 TH, 3 + part its OPTT.
using Source = std::uint64_t;
constexpr Source global_source = 2, first_part_source = 3, no_source = ~Source{0};

Source source(ThicknessRule rule, bool side_b, PartIndex part) {
  switch (rule) {
    case ThicknessRule::contact_card:
      return side_b ? 1 : 0;
    case ThicknessRule::global:
      return global_source;
    case ThicknessRule::part_contact:
      return first_part_source + part.value;
    default:
      return no_source;
  }
}

/// The direction of an override that is far from the elements' own thickness.
enum class Far : std::uint8_t { no, above, below };
Far far(double half, double own) {
  if (!(own > 0)) return Far::no;
  return half > far_factor * own ? Far::above : far_factor * half < own ? Far::below : Far::no;
}

/// One override in one contact, over the segments where it is far off.
struct Override {
  double value = 0;
  double thinnest = 0, thickest = 0;  ///< of the elements' own
  bool above = false, below = false;
  std::uint64_t made = 0, hidden = 0;  ///< penetrations that exist only because of it, and that it hides
  const Penetration* deepest = nullptr;
};

/// The overrides of one contact, and its surfaces with them and without.
struct Candidate {
  ContactIndex contact;
  const contact::ContactSurfaces* given = nullptr;
  const contact::ContactSurfaces* own = nullptr;
  std::map<Source, Override> overrides;
};

bool has_override(const model::Model& model, const model::Contact& contact) {
  return contact.sst != 0 || contact.mst != 0 || model.controls.th != 0 ||
         std::any_of(model.parts.begin(), model.parts.end(),
                     [](const model::Part& part) { return part.contact && part.contact->optt != 0; });
}

void note(Candidate& candidate, Source from, double half, double own) {
  const Far way = far(half, own);
  if (from == no_source || way == Far::no) return;
  Override& o = candidate.overrides[from];
  const bool first = !o.above && !o.below;
  o.value = 2 * half;
  (way == Far::above ? o.above : o.below) = true;
  o.thinnest = first ? 2 * own : std::min(o.thinnest, 2 * own);
  o.thickest = std::max(o.thickest, 2 * own);
}

void note_side(Candidate& candidate, const model::Mesh& mesh, bool b) {
  const contact::ContactSide& given = b ? candidate.given->b : candidate.given->a;
  const contact::ContactSide& own = b ? candidate.own->b : candidate.own->a;
  const contact::Segments& s = given.selection.segments;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PartIndex part = s.rule[i] == ThicknessRule::part_contact ? part_of(mesh, s, i) : none<PartIndex>;
    note(candidate, source(s.rule[i], b, part), s.half[i], own.selection.segments.half[i]);
  }
  if (!given.nodes_only) return;
  for (std::size_t i = 0; i < given.nodes.size(); ++i)
    note(candidate, source(given.nodes.rule[i], b, given.nodes.part[i]), given.nodes.half[i], own.nodes.half[i]);
}

/// The overrides behind a pair that go one way: of its node and of its segment.
struct PairSources {
  Source node = no_source, segment = no_source;
  double own_distance = 0;  ///< contact distance without overrides
};

PairSources sources(const Candidate& candidate, const model::Mesh& mesh, const Penetration& record, Far way) {
  PairSources result;
  const auto pair = contact::find_pair(*candidate.given, mesh, record);
  if (!pair) return result;
  const auto side = [](const contact::ContactSurfaces& s, bool b) -> const contact::ContactSide& {
    return b ? s.b : s.a;
  };
  const contact::TrackedNodes& nodes = side(*candidate.given, pair->node_on_b).nodes;
  const contact::Segments& segments = side(*candidate.given, pair->segment_on_b).selection.segments;
  const double own_node = side(*candidate.own, pair->node_on_b).nodes.half[pair->slot.value];
  const double own_segment = side(*candidate.own, pair->segment_on_b).selection.segments.half[pair->segment.value];
  result.own_distance = own_node + own_segment;
  if (far(nodes.half[pair->slot.value], own_node) == way)
    result.node = source(nodes.rule[pair->slot.value], pair->node_on_b, nodes.part[pair->slot.value]);
  if (far(segments.half[pair->segment.value], own_segment) == way)
    result.segment =
        source(segments.rule[pair->segment.value], pair->segment_on_b, part_of(mesh, segments, pair->segment.value));
  return result;
}

/// Counts records under the overrides that cause them; `made`: those that would not exist with the elements' own
/// thickness.
void count(Candidate& candidate, const model::Mesh& mesh, std::span<const Penetration> records, bool made) {
  const auto found = worst_by_key(2 * records.size(), [&](std::size_t i) {
    const Penetration& p = records[i / 2];
    if (!listed_by_solver(p.kind)) return Weighed{};
    const PairSources from = sources(candidate, mesh, p, made ? Far::above : Far::below);
    const bool of_segment = i % 2 == 1;
    const Source key = of_segment ? from.segment : from.node;
    if (key == no_source || (of_segment && key == from.node)) return Weighed{};
    const double tolerance = contact::default_tolerance(from.own_distance, p.original.cwiseAbs().maxCoeff());
    if (made && from.own_distance - p.remaining() > tolerance) return Weighed{};
    return Weighed{key, rough_weight(p.depth), p.node};
  });
  for (const Worst& w : found) {
    const auto entry = candidate.overrides.find(w.key);
    if (entry == candidate.overrides.end()) continue;
    (made ? entry->second.made : entry->second.hidden) = w.count;
    if (made || entry->second.deepest == nullptr) entry->second.deepest = &records[w.item / 2];
  }
}

class Overrides {
 public:
  Overrides(const RuleIdentity& rule, Context& context, Report& report)
      : rule_(rule),
        context_(context),
        model_(context.model()),
        report_(report),
        own_(model_, std::vector<contact::ThicknessChange>(model_.contacts.size(), {.own = true})) {}

  void run() {
    std::size_t unchecked = 0;
    for (const ContactIndex i : contacts_with_thickness(rule_, context_)) {
      if (!has_override(model_, model_.contact(i))) continue;
      if (!contact::classify(model_.contact(i)).checked())
        ++unchecked;
      else
        look(i);
    }
    if (unchecked > 0)
      context_.skipped(rule_, fmt::format("{} contacts with another thickness whose nodes are not checked", unchecked));
    find_hidden();
    context_.results().count_other(own_);
    for (const Candidate& candidate : candidates_)
      for (const auto& [from, o] : candidate.overrides) add(candidate, from, o);
  }

 private:
  void look(ContactIndex i) {
    Candidate candidate{i, &context_.surfaces(i), &own_.at(i), {}};
    for (const bool b : {false, true}) note_side(candidate, model_.mesh, b);
    if (candidate.overrides.empty()) return;
    count(candidate, model_.mesh, records_of(context_.results().initial(), i), true);
    candidates_.push_back(std::move(candidate));
  }

  /// Searches once more without the overrides, where some are smaller than the elements' own thickness.
  void find_hidden() {
    std::vector<ContactIndex> chosen;
    for (const Candidate& candidate : candidates_)
      if (std::any_of(candidate.overrides.begin(), candidate.overrides.end(),
                      [](const auto& o) { return o.second.below; }))
        chosen.push_back(candidate.contact);
    if (chosen.empty()) return;
    hidden_ = context_.results().initial_if(own_, chosen);
    std::erase_if(hidden_.penetrations, [known = std::int64_t{-1}, nodes = std::unordered_set<std::int64_t>{},
                                         this](const Penetration& p) mutable {
      if (known != p.contact) {
        known = p.contact;
        nodes.clear();
        for (const Penetration& found : records_of(context_.results().initial(), ContactIndex{p.contact}))
          if (listed_by_solver(found.kind)) nodes.insert(found.node);
      }
      return nodes.contains(p.node);
    });
    for (Candidate& candidate : candidates_)
      count(candidate, model_.mesh, records_of(hidden_, candidate.contact), false);
  }

  void add(const Candidate& candidate, Source from, const Override& o) {
    if (o.made == 0 && o.hidden == 0) return;
    const model::Contact& contact = model_.contact(candidate.contact);
    std::string message = fmt::format("{} where the elements have {}", name(from, o), own_range(o));
    if (o.made > 0)
      message +=
          fmt::format(": {} of {} penetrations exist only by it; lower it", o.made, penetrations(candidate.contact));
    if (o.hidden > 0)
      message += fmt::format(
          ": it hides {} penetrations that the elements' own thickness has; raise it or move the nodes", o.hidden);
    Finding f = finding_at(rule_, context_, contact, std::move(message));
    if (from >= first_part_source) f.part = model_.parts[from - first_part_source].id.value;
    f.count = o.made + o.hidden;
    f.node = o.deepest->node;
    f.element = o.deepest->element;
    f.element_part = o.deepest->element_part;
    f.penetration = o.deepest->depth;
    f.contact_distance = o.deepest->contact_distance;
    f.point = o.deepest->original;
    report_.findings.push_back(std::move(f));
  }

  [[nodiscard]] std::string name(Source from, const Override& o) const {
    if (from >= first_part_source)
      return fmt::format("OPTT = {:.4g} of part {}", o.value, model_.parts[from - first_part_source].id.value);
    const char* field = from == global_source ? "TH of *CONTROL_CONTACT" : from == 0 ? "SST" : "MST";
    return fmt::format("{} = {:.4g}", field, o.value);
  }

  static std::string own_range(const Override& o) {
    if (o.thinnest == o.thickest) return fmt::format("{:.4g}", o.thinnest);
    return fmt::format("{:.4g} to {:.4g}", o.thinnest, o.thickest);
  }

  [[nodiscard]] std::uint64_t penetrations(ContactIndex contact) {
    const auto records = records_of(context_.results().initial(), contact);
    return static_cast<std::uint64_t>(
        std::count_if(records.begin(), records.end(), [](const Penetration& p) { return listed_by_solver(p.kind); }));
  }

  const RuleIdentity& rule_;
  Context& context_;
  const model::Model& model_;
  Report& report_;
  contact::SurfaceStore own_;
  std::vector<Candidate> candidates_;
  contact::InitialState hidden_;
};

void run(const RuleIdentity& rule, Context& context, Report& report) { Overrides(rule, context, report).run(); }

}  // namespace

const Rule definition{
    {"GC301", "thickness-override", Severity::warning,
     "SST, MST, TH or OPTT far from the real thickness makes penetrations or hides them",
     Need::surfaces | Need::node_penetrations, "Contact happens at a distance where the parts do not meet"},
    run};

}  // namespace gapcheck::audit::rule::thickness_override
