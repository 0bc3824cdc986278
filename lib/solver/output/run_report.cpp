#include "solver/output/run_report.hpp"

#include <algorithm>
#include <tuple>

#include "contact/stiffness/contact_timestep.hpp"
#include "contact/stiffness/element_timestep.hpp"
#include "contact/tie/record_tie.hpp"

namespace gapcheck::solver {

Report run_report(const Run& run, contact::SurfaceStore& surfaces) {
  const model::Model& model = run.model();
  Report report;
  report.contacts = run.initial().contacts;
  report.penetrations = run.initial().penetrations;
  for (const contact::JudgedNode& judged : run.initial().judged)
    if (!judged.tied()) report.tie_failures.push_back(contact::record_tie(judged, model));
  std::stable_sort(report.tie_failures.begin(), report.tie_failures.end(),
                   [](const TieFailure& a, const TieFailure& b) {
                     return std::tie(a.contact, a.reason, a.node) < std::tie(b.contact, b.reason, b.node);
                   });
  const std::vector<ContactIndex> all = positions<ContactIndex>(model.contacts.size()).list();
  report.predicted = contact::predict_timesteps(model, surfaces, all).timesteps;
  return report;
}

std::vector<results::ContactDefinition> contact_definitions(const model::Model& model,
                                                            contact::SurfaceStore& surfaces) {
  std::vector<results::ContactDefinition> list;
  for (const ContactIndex i : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& contact = model.contact(i);
    if (contact.order == 0) continue;  // *CONTACT_INTERIOR and others define no interface
    results::ContactDefinition d;
    d.id = contact.id.value;
    d.order = contact.order;
    d.title = contact.title;
    const contact::ContactType type = contact::classify(contact);
    d.type = type.printed();
    if (contact.known && !contact.own_layout) {
      const contact::ContactSurfaces& sides = surfaces.at(i);
      d.segments_a = sides.a.selection.segments.size();
      d.segments_b = sides.b.selection.segments.size();
    }
    d.static_friction = contact.fs;
    d.kinetic_friction = contact.fd;
    d.friction_decay = contact.dc;
    d.viscous_friction = contact.vc;
    d.thickness_a = contact.sst;
    d.thickness_b = contact.mst;
    d.thickness_scale_a = contact.sfst;
    d.thickness_scale_b = contact.sfmt;
    d.birth = contact.birth;
    d.death = contact.death;
    d.ignore = contact::settings(contact, type, model.controls).ignore;
    d.soft = contact.soft;
    list.push_back(d);
  }
  return list;
}

std::vector<results::ElementStep> element_steps(const model::Model& model, const contact::ElementSizes& sizes) {
  std::vector<results::ElementStep> list;
  const auto add = [&](const char* kind, const auto& elements, const contact::ElementTimestep& step) {
    const PartIndex part = elements.part[step.element];
    list.push_back(
        {kind, elements.id[step.element], part == none<PartIndex> ? 0 : model.part(part).id.value, step.timestep});
  };
  for (const contact::ElementTimestep& step : contact::smallest_element_timesteps(model, sizes, 100)) {
    switch (step.kind) {
      case model::ElementKind::shell:
        add("shell", model.mesh.shells, step);
        break;
      case model::ElementKind::solid:
        add("solid", model.mesh.solids, step);
        break;
      case model::ElementKind::thick_shell:
        add("tshell", model.mesh.thick_shells, step);
        break;
      default:
        add("beam", model.mesh.beams, step);
    }
  }
  return list;
}

}  // namespace gapcheck::solver
