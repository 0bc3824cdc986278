#include <fmt/format.h>

#include <algorithm>

#include "base/number.hpp"
#include "model/read/cards.hpp"
#include "model/read/context.hpp"
#include "model/read/plies.hpp"

namespace gapcheck::model {
namespace {

PartContact read_part_contact(Context& context, CardReader& reader) {
  const Card card = reader.next(keyword::card_layout("PART_CONTACT", "card3"));
  PartContact contact;
  contact.fs = card.real("fs");
  contact.fd = card.real("fd");
  contact.dc = context.decay(reader.block(), card.real("dc"));
  contact.vc = context.stress(reader.block(), card.real("vc"));
  contact.optt = context.length(reader.block(), card.real("optt"));
  contact.sft = card.real("sft");
  contact.ssf = card.real("ssf");
  return contact;
}

/// The plies of *PART_COMPOSITE, up to the end of the block: the sum of their thicknesses, and the first material.
void read_part_plies(Context& context, CardReader& reader, bool one_per_line, Part& part) {
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(ply_line());
    if (part.material_id == 0) part.material_id = card.integer(0);
    for (const std::size_t first : {std::size_t{0}, std::size_t{4}}) {
      const double thickness = context.length(reader.block(), card.real(first + 1));
      if (first > 0 && (one_per_line || thickness == 0)) break;
      part.plies.push_back({card.integer(first), thickness, std::nullopt});
      part.composite_thickness += thickness;
    }
  }
}

/// A composite part is its own section.
Section composite_section(const Part& part, const Card& card, bool thick_shell) {
  Section section;
  section.kind = thick_shell ? SectionKind::thick_shell : SectionKind::shell;
  section.elform = card.integer("elform");
  section.nloc = thick_shell ? 0 : card.real("nloc");
  if (card.real("shrf") != 0) section.shrf = card.real("shrf");
  section.thickness.fill(part.composite_thickness);
  section.place = part.place;
  return section;
}

void read_composite(Context& context, CardReader& reader, const Options& options, Part& part) {
  const bool thick_shell = options.has("TSHELL");
  const Card card =
      reader.next(keyword::card_layout(thick_shell ? "PART_COMPOSITE_TSHELL" : "PART_COMPOSITE", "card2"));
  part.id = PartId(card.integer("pid"));
  part.place.line = card.line();
  part.hourglass_id = card.integer("hgid");
  if (options.has("CONTACT")) part.contact = read_part_contact(context, reader);
  read_part_plies(context, reader, options.has("LONG"), part);
  part.section = static_cast<std::uint32_t>(context.model.sections.size());
  context.model.sections.push_back(composite_section(part, card, thick_shell));
}

void read_plain(Context& context, CardReader& reader, const Options& options, Part& part) {
  const Card card = reader.next(keyword::card_layout("PART", "card1.2"));
  part.id = PartId(card.integer("pid"));
  part.section_id = card.integer("secid");
  part.material_id = card.integer("mid");
  part.place.line = card.line();
  part.hourglass_id = card.integer("hgid");
  part.eos_id = card.integer("eosid");
  if (options.has("INERTIA")) part.inertia = read_body_inertia(context, reader);
  if (options.has("REPOSITION")) reader.skip();
  if (options.has("CONTACT")) part.contact = read_part_contact(context, reader);
  skip_lines(reader, static_cast<std::int64_t>(options.count({"PRINT", "ATTACHMENT", "FIELD"})));
}

void add_part(Context& context, Part part) {
  Model& model = context.model;
  if (part.id.value <= 0) {
    context.bad_id(part.place, fmt::format("part id {} is not positive; the part is left out", part.id.value));
    return;
  }
  const auto [entry, is_new] =
      model.part_of_id.try_emplace(part.id.value, static_cast<std::uint32_t>(model.parts.size()));
  if (is_new)
    model.parts.push_back(std::move(part));
  else
    context.duplicate("part", part.id.value, model.part(entry->second).place, part.place);
}

}  // namespace

void read_parts(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    const Card heading = reader.next(text_line());
    Part part;
    part.title = heading.text(std::size_t{0});
    part.place = Context::place(block, heading.line());
    if (trimmed(reader.peek()).empty() && part.title.empty()) continue;
    if (reader.at_end()) {
      context.error(part.place, fmt::format("*{} ends after the heading \"{}\"; the part's card is missing", block.name,
                                            part.title));
      return;
    }
    if (options.has("COMPOSITE"))
      read_composite(context, reader, options, part);
    else
      read_plain(context, reader, options, part);
    add_part(context, std::move(part));
  }
}

void read_later_particles(Context& context, const Block& block, const Options& options) {
  const CardLayout& layout = keyword::card_layout("DEFINE_ADAPTIVE_SOLID_TO_SPH", "card1");
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("ID")) reader.skip();
  const Card card = reader.next(layout);
  Part part;
  part.id = PartId(card.integer("npid"));
  part.title = "particles of failed solids";
  part.section_id = card.integer("nsid");
  part.place = Context::place(block, card.line());
  if (part.id.value > 0) context.later_particles.push_back(std::move(part));
}

/// The parts of later particles, those without a *PART among them.
void add_later_particles(Context& context) {
  Model& model = context.model;
  for (Part& part : context.later_particles) {
    const auto [entry, is_new] =
        model.part_of_id.try_emplace(part.id.value, static_cast<std::uint32_t>(model.parts.size()));
    model.later_particles.push_back(entry->second);
    if (is_new) model.parts.push_back(std::move(part));
  }
  std::sort(model.later_particles.begin(), model.later_particles.end());
  model.later_particles.erase(std::unique(model.later_particles.begin(), model.later_particles.end()),
                              model.later_particles.end());
}

void finish_parts(Context& context) {
  add_later_particles(context);
  const auto find = [](const auto& table, std::int64_t id) -> std::optional<std::uint32_t> {
    const auto found = table.find(id);
    return found == table.end() ? std::nullopt : std::optional(found->second);
  };
  for (Part& part : context.model.parts) {
    if (!part.section) part.section = find(context.section_of_id, part.section_id);
    part.material = find(context.material_of_id, part.material_id);
    for (Ply& ply : part.plies) ply.material = find(context.material_of_id, ply.material_id);
  }
}

void finish_sections(Context& context) {
  for (Section& section : context.model.sections)
    if (section.kind == SectionKind::shell && section.elform == 0) section.elform = context.model.controls.shell_theory;
}

}  // namespace gapcheck::model
