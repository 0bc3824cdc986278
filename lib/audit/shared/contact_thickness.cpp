#include "audit/shared/contact_thickness.hpp"

#include <fmt/format.h>

#include "audit/grouped.hpp"

namespace gapcheck::audit {
namespace {

using contact::Segments;

/// Where the element of a segment is defined in the deck.
model::Place place_of(const model::Mesh& mesh, const Segments& s, std::size_t i) {
  const auto at = [e = s.element[i]](const auto& elements) {
    return model::Place{elements.origins.file(e), elements.line[e]};
  };
  switch (s.element_kind[i]) {
    case model::ElementKind::shell:
      return at(mesh.shells);
    case model::ElementKind::solid:
      return at(mesh.solids);
    case model::ElementKind::thick_shell:
      return at(mesh.thick_shells);
    case model::ElementKind::beam:
      return at(mesh.beams);
    default:
      return {};
  }
}

}  // namespace

std::vector<ContactIndex> contacts_with_thickness(const RuleIdentity& rule, Context& context) {
  std::vector<ContactIndex> list;
  std::size_t tied = 0;
  for (const ContactIndex i : context.contacts()) {
    const contact::ContactType type = contact::classify(context.model().contact(i));
    if (type.treatment == contact::Treatment::none || type.family == contact::Family::other) continue;
    if (type.family == contact::Family::tied)
      ++tied;
    else
      list.push_back(i);
  }
  if (tied > 0) context.skipped(rule, fmt::format("{} tied contacts: thickness only decides what ties there", tied));
  return list;
}

void weigh_by_part(std::vector<PartSegments>& list, const Context& context, ContactIndex contact,
                   const Segments& segments, const std::function<double(std::size_t)>& weigh) {
  const model::Model& model = context.model();
  const auto all = worst_by_key(segments.size(), [&](std::size_t i) {
    const double weight = weigh(i);
    if (!(weight > 0)) return Weighed{};
    const PartIndex part = part_of(model.mesh, segments, i);
    return Weighed{part.value, part == none<PartIndex> ? 0 : rough_weight(weight), element_id(model.mesh, segments, i)};
  });
  for (const Worst& worst : all) {
    const PartSegments part{contact, &segments, worst};
    if (context.part_chosen(part.part())) list.push_back(part);
  }
}

void add_by_part(const RuleIdentity& rule, const Context& context, Report& report,
                 const std::vector<PartSegments>& list, const std::function<std::string(const PartSegments&)>& words,
                 const std::string& others) {
  const model::Model& model = context.model();
  std::vector<Found> found;
  for (std::size_t i = 0; i < list.size(); ++i)
    found.push_back({list[i].contact.value, list[i].worst.weight, i, {model.part(list[i].part()).id.value}});
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const PartSegments& part = list[f.item];
        Finding one = finding_at_segment(rule, context, model.contact(part.contact), *part.segments, part.worst.item,
                                         words(part));
        one.count = part.worst.count;
        return one;
      },
      [&](const Found& f, std::uint64_t count) {
        return finding_at(rule, context, model.contact(list[f.item].contact), fmt::format("{} more {}", count, others));
      });
}

Finding finding_at_segment(const RuleIdentity& rule, const Context& context, const model::Contact& contact,
                           const Segments& segments, std::size_t segment, std::string message) {
  const model::Mesh& mesh = context.model().mesh;
  const model::Place place = place_of(mesh, segments, segment);
  Finding f = finding(rule, std::move(message), context.path(place.file), place.line);
  f.contact = contact.id.value;
  f.element = element_id(mesh, segments, segment);
  const PartIndex part = part_of(mesh, segments, segment);
  if (part != none<PartIndex>) f.part = f.element_part = context.model().part(part).id.value;
  const auto& n = segments.nodes[segment];
  f.point = (mesh.nodes.x[n[0].value] + mesh.nodes.x[n[2].value]) / 2;
  return f;
}

std::string part_name(const model::Model& model, PartIndex part) {
  return fmt::format("part {}", model.part(part).id.value);
}

std::string element_name(const model::Mesh& mesh, const Segments& segments, std::size_t segment) {
  const bool shell = segments.element_kind[segment] == model::ElementKind::shell;
  return fmt::format("{} {}", shell ? "shell" : "element", element_id(mesh, segments, segment));
}

std::string count_elements(std::uint64_t count) { return fmt::format("{} element{}", count, count == 1 ? "" : "s"); }

}  // namespace gapcheck::audit
