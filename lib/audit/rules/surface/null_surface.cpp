#include <fmt/format.h>

#include <vector>

#include "audit/rules.hpp"
#include "contact/stiffness/contact_timestep.hpp"
#include "contact/stiffness/stiffness.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::audit::rule::null_surface {
namespace {

/// Which parts give contact springs no stiffness. A solid's *MAT_NULL has that of its equation of state.
class WeakParts {
 public:
  explicit WeakParts(const model::Model& model) : mesh_(model.mesh) {
    for (std::uint32_t p = 0; p < model.parts.size(); ++p) {
      const auto& material = model.parts[p].material;
      const bool zero = material && model.materials[*material].stiffness_known &&
                        !(contact::contact_modulus(model.materials[*material]) > 0);
      weak_.push_back(zero);
      null_.push_back(zero && model.materials[*material].null_material);
    }
  }
  [[nodiscard]] bool weak(const contact::Segments& s, std::size_t i) const {
    const PartIndex part = contact::part_of(mesh_, s, i);
    if (part == none<PartIndex> || !weak_[part.value]) return false;
    return s.element_kind[i] == model::ElementKind::shell || !null_[part.value];
  }

 private:
  const model::Mesh& mesh_;
  std::vector<bool> weak_, null_;
};

void check_side(const RuleIdentity& rule, Context& context, Report& report, ContactIndex contact, char letter,
                const contact::Segments& s, const WeakParts& parts) {
  const model::Model& model = context.model();
  std::size_t segments = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.kind[i] == contact::SegmentKind::line) continue;
    if (!parts.weak(s, i)) return;
    ++segments;
  }
  if (segments == 0) return;
  const PartIndex part = contact::part_of(model.mesh, s, 0);
  const model::Part& first = model.part(part);
  Finding f = finding_at(
      rule, context, model.contact(contact),
      fmt::format("side {} has no stiffness: {} of materials with E = 0 (first: part {}, *{} {}), so the contact gives "
                  "no force; "
                  "set E and PR of the material, or SOFT = 1",
                  letter, segments == 1 ? "its only segment is" : fmt::format("all its {} segments are", segments),
                  first.id.value, model.materials[*first.material].keyword, first.material_id));
  f.part = first.id.value;
  report.findings.push_back(std::move(f));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const WeakParts parts(model);
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = model.contact(i);
    if (contact.soft != 0 || !contact.known || contact.own_layout) continue;
    const contact::ContactType type = contact::classify(contact);
    if (type.code == contact::ContactCode::transducer || !contact::has_timestep(type)) continue;
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    check_side(rule, context, report, i, 'A', surfaces.a.selection.segments, parts);
    if (surfaces.two_sided()) check_side(rule, context, report, i, 'B', surfaces.b.selection.segments, parts);
  }
}

}  // namespace

const Rule definition{{"GC418", "null-surface", Severity::warning,
                       "a side of a contact consists of materials without stiffness: the contact gives no force",
                       Need::surfaces, "The contact gives no force"},
                      run};

}  // namespace gapcheck::audit::rule::null_surface
