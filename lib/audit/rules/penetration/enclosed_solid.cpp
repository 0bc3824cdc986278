#include <fmt/format.h>

#include <map>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "audit/shared/element_text.hpp"
#include "audit/shared_results.hpp"
#include "contact/crossing/enclosed_bodies.hpp"

namespace gapcheck::audit::rule::enclosed_solid {
namespace {

using contact::EnclosedBody;

/// Parts with solid faces on the two sides of a contact, as masks over Model::parts.
struct SolidParts {
  std::vector<bool> a, b;
};

std::vector<bool> solid_parts(const model::Model& model, const contact::Segments& segments) {
  std::vector<bool> mask(model.parts.size(), false);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments.element_kind[i] != model::ElementKind::solid) continue;
    const PartIndex part = contact::part_of(model.mesh, segments, i);
    if (part != none<PartIndex>) mask[part.value] = true;
  }
  return mask;
}

/// Which contact acts on two parts; reads the contacts on the first call.
class ActingContact {
 public:
  explicit ActingContact(Context& context) : context_(context) {}

  ContactIndex operator()(PartIndex p, PartIndex q) {
    const model::Model& model = context_.model();
    for (const ContactIndex i : context_.contacts()) {
      if (contact::classify(model.contact(i)).pairing == contact::Pairing::none) continue;
      const SolidParts& parts = solids(i);
      const bool acts = (parts.a[p.value] && parts.b[q.value]) || (parts.a[q.value] && parts.b[p.value]);
      if (acts && contact::CrossingPairs(model, model.contact(i).id).counts(p, q)) return i;
    }
    return none<ContactIndex>;
  }

 private:
  const SolidParts& solids(ContactIndex i) {
    const auto known = parts_.find(i);
    if (known != parts_.end()) return known->second;
    const contact::ContactSurfaces& s = context_.surfaces(i);
    SolidParts parts{solid_parts(context_.model(), s.a.selection.segments), {}};
    parts.b = s.two_sided() ? solid_parts(context_.model(), s.b.selection.segments) : parts.a;
    return parts_.emplace(i, std::move(parts)).first->second;
  }

  Context& context_;
  std::map<ContactIndex, SolidParts> parts_;
};

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  contact::CrossingOptions options;
  options.mode = context.options().exact ? geometry::Mode::exact : geometry::Mode::filtered;
  options.search = context.options().brute_force ? contact::BoxSearch::brute_force : contact::BoxSearch::tree;
  ActingContact acting(context);
  const std::vector<EnclosedBody> bodies = contact::find_enclosed_bodies(
      model, [&](PartIndex p, PartIndex q) { return acting(p, q); }, options, context.results().crossing_counters());
  std::vector<Found> found;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (context.part_chosen(bodies[i].inner) || context.part_chosen(bodies[i].outer))
      found.push_back({part_pair(bodies[i].inner, bodies[i].outer), static_cast<double>(bodies[i].solids), i});
  const auto words = [&](const Found& f, std::string message) {
    const EnclosedBody& body = bodies[f.item];
    Finding out = finding_at(rule, context, model.contact(body.contact), std::move(message));
    place_at_element(out, context, {model::ElementKind::solid, body.first_solid});
    out.element_part = part_id(model, body.inner);
    out.part = part_id(model, body.outer);
    out.point = body.point;
    return out;
  };
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const EnclosedBody& body = bodies[f.item];
        const bool one = body.solids == 1;
        return words(f, fmt::format("{} solid{} of {} (from solid {} on) lie{} wholly inside {}; cut the space out of "
                                    "{}, or exclude the pair from the contact",
                                    body.solids, one ? "" : "s", part_text(model, body.inner),
                                    model.mesh.solids.id[body.first_solid], one ? "s" : "",
                                    part_text(model, body.outer), part_text(model, body.outer)));
      },
      [&](const Found& f, std::uint64_t count) {
        const EnclosedBody& body = bodies[f.item];
        return words(f, fmt::format("{} more bod{} of {} inside {}", count, count == 1 ? "y" : "ies",
                                    part_text(model, body.inner), part_text(model, body.outer)));
      });
}

}  // namespace

const Rule definition{
    {"GC105", "enclosed-solid", Severity::warning,
     "a body of solids lies wholly inside another that it is in contact with", Need::surfaces | Need::crossings,
     "The inner body is never pushed out: contact sees it from inside"},
    run};

}  // namespace gapcheck::audit::rule::enclosed_solid
