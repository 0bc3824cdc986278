#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number.hpp"
#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

constexpr std::int64_t first_user_form = 101, last_user_form = 105;

bool user_defined(std::int64_t elform) { return elform >= first_user_form && elform <= last_user_form; }

/// Number of lines for a list of `count` numbers, eight in each; safe for any count.
std::int64_t lines_of_eight(std::int64_t count) { return count <= 0 ? 0 : (count - 1) / 8 + 1; }

void add_section(Context& context, Section section) {
  if (section.id <= 0) {
    context.bad_id(section.place, fmt::format("section id {} is not positive; the section is left out", section.id));
    return;
  }
  Model& model = context.model;
  const auto [entry, is_new] =
      context.section_of_id.try_emplace(section.id, static_cast<std::uint32_t>(model.sections.size()));
  if (is_new)
    model.sections.push_back(section);
  else
    context.duplicate("section", section.id, model.sections[entry->second].place, section.place);
}

Section begin_section(const Block& block, const Card& card, SectionKind kind) {
  Section section;
  section.id = card.integer("secid");
  section.kind = kind;
  section.elform = card.integer("elform");
  section.place = Context::place(block, card.line());
  return section;
}

/// Titles have blanks or begin with a letter.
bool may_be_number(std::string_view text) {
  return parse_real(text) || (keyword::is_parameter_reference(text) && text.find(' ') == std::string_view::npos &&
                              std::string_view("&-+(<.0123456789").find(text.front()) != std::string_view::npos);
}

/// The card contains only numbers, so it is not one of the titles allowed from the second section on.
bool is_section_card(const CardReader& reader, const CardLayout& layout) {
  const Card card = reader.peek(layout);
  for (std::size_t i = 0; i < card.size(); ++i) {
    const std::string_view text = card.text(i);
    if (!text.empty() && !may_be_number(text)) return false;
  }
  return !card.text(std::size_t{0}).empty();
}

/// Calls read(reader) for every section of a block and skips titles and blank lines between them.
template <class Read>
void for_each_section(Context& context, const Block& block, const Options& options, const CardLayout& card1,
                      const Read& read) {
  CardReader reader(context.deck, block, context.diagnostics);
  bool title = options.has("TITLE");
  while (!reader.at_end()) {
    if (title) {
      reader.skip();
      if (reader.at_end()) context.error(Context::place(block, block.line), "the section's card is missing");
    }
    if (!reader.at_end() && !skip_blank(reader)) read(reader);
    while (!reader.at_end() && skip_blank(reader)) continue;
    title = options.has("TITLE") && !reader.at_end() && !is_section_card(reader, card1);
  }
}

/// Cross-section of a beam in its own lengths.
struct Profile {
  double radius = 0, area = 0;
  std::optional<BeamSection> constants;
  std::optional<BeamProfile> ends = {};
  std::optional<DiscreteBeamSection> spring = {};
};

Profile equal_area(double area) { return {area > 0 ? std::sqrt(area / std::numbers::pi) : 0, area, std::nullopt}; }

Profile tube(double outer_diameter, double inner_diameter) {
  const double outer = outer_diameter * outer_diameter, inner = inner_diameter * inner_diameter;
  Profile profile{outer_diameter / 2, std::numbers::pi / 4 * (outer - inner), std::nullopt};
  const double second = std::numbers::pi / 64 * (outer * outer - inner * inner);
  profile.constants = BeamSection{profile.area, second, second, 2 * second, 0, 0};
  return profile;
}

/// Sides along s and t. Torsion: Roark's approximation for rectangles, within 0.2 %; shear area 5/6.
Profile rectangle(double along_s, double along_t) {
  Profile profile = equal_area(along_s * along_t);
  const double a = std::max(along_s, along_t), b = std::min(along_s, along_t);
  if (!(b > 0)) return profile;
  const double ratio = b / a, cubed = a * b * b * b;
  const double torsion = cubed * (1.0 / 3 - 0.21 * ratio * (1 - ratio * ratio * ratio * ratio / 12));
  const double area = profile.area;
  profile.constants =
      BeamSection{area, area * along_t * along_t / 12, area * along_s * along_s / 12, torsion, area * 5 / 6, 0};
  return profile;
}

/// The constants of resultant beams and trusses.
Profile resultants(const Card& card) {
  Profile profile = equal_area(card.real("a"));
  profile.constants =
      BeamSection{card.real("a"), card.real("iss"), card.real("itt"), card.real("j"), card.real("sas"), 0};
  return profile;
}

/// SECTION_nn: the named shapes whose area is plain; nothing for the others.
std::optional<Profile> named_profile(std::string_view name, double d1, double d2) {
  if (name.ends_with("08")) return tube(2 * d1, 0);
  if (name.ends_with("09")) return tube(2 * d1, 2 * d2);
  if (name.ends_with("11")) return equal_area(d1 * d2);
  return std::nullopt;
}

Profile read_named_profile(Context& context, CardReader& reader) {
  static const CardLayout layout = [] {
    CardLayout card = id_and_reals(IdKind::plain, 6);
    card.fields[0].type = FieldType::text;
    return card;
  }();
  const Card card = reader.next(layout);
  if (const auto profile = named_profile(card.text(std::size_t{0}), card.real(1), card.real(2))) return *profile;
  context.warning(Context::place(reader.block(), card.line()),
                  fmt::format("the area of the beam section {} is not computed; its contact radius is taken as 0",
                              card.text(std::size_t{0})));
  return {};
}

/// Both ends of an integrated beam, in its own lengths; what is blank at the second end is as at the first.
BeamProfile integrated_profile(const Card& card, std::int64_t cst) {
  const auto ends = [&](std::string_view one, std::string_view two) {
    const double a = card.real(one), b = card.real(two);
    return std::array<double, 2>{a, b == 0 ? a : b};
  };
  BeamProfile profile;
  profile.tube = cst == 1;
  profile.arbitrary = cst != 0 && cst != 1;
  profile.s = ends("ts1", "ts2");
  profile.t = ends("tt1", "tt2");
  profile.location = {card.real("nsloc"), card.real("ntloc")};
  profile.torsion_free = card.real("itoff") == 1;
  return profile;
}

DiscreteBeamSection read_spring(const Card& card) {
  DiscreteBeamSection spring;
  spring.volume = card.real("vol");
  spring.inertia = card.real("iner");
  spring.system = card.integer("cid");
  spring.cable_area = card.real("ca/dofn1");
  spring.cable_offset = card.real("offset/dofn2");
  spring.fixed = {card.real("rrcon/null") == 1, card.real("srcon/null") == 1, card.real("trcon/null") == 1};
  return spring;
}

Profile read_profile(Context& context, CardReader& reader, std::int64_t elform, std::int64_t cst) {
  if (trimmed(reader.peek()).starts_with("SECTION_")) return read_named_profile(context, reader);
  switch (elform) {
    case 3: {
      Profile truss = equal_area(reader.next(keyword::card_layout("SECTION_BEAM", "card3")).real("a"));
      truss.constants = BeamSection{truss.area, 0, 0, 0, 0, 0};
      return truss;
    }
    case 2:
    case 12:
    case 13:
      return resultants(reader.next(keyword::card_layout("SECTION_BEAM", "card3")));
    case discrete_beam: {
      Profile profile;
      profile.spring = read_spring(reader.next(keyword::card_layout("SECTION_BEAM", "card6")));
      return profile;
    }
    default:
      break;
  }
  const bool integrated = elform == 1 || elform == 9;
  const Card card = reader.next(keyword::card_layout("SECTION_BEAM", elform == 9 ? "card7" : "card2"));
  const double width = card.real("ts1"), height = card.real("tt1");
  const bool plane_or_tube = cst == 1 || elform == 4 || elform == 5;
  Profile profile = plane_or_tube ? tube(width, height) : rectangle(width, height);
  if (integrated) profile.ends = integrated_profile(card, cst);
  return profile;
}

/// What *SECTION_BEAM says of its shape, in the model's units.
void set_beam(const Context& context, const Block& block, const Profile& profile, const Card& card, Section& section) {
  section.beam_radius = context.length(block, profile.radius);
  const double length = context.transform(block).length_factor, square = length * length;
  section.beam_area = profile.area * square;
  section.beam = profile.constants;
  if (section.beam) {
    section.beam->area *= square;
    section.beam->shear_area *= square;
    for (double BeamSection::*moment : {&BeamSection::iss, &BeamSection::itt, &BeamSection::torsion})
      (*section.beam).*moment *= square * square;
    section.beam->line_mass = card.real("nsm") * context.transform(block).mass_factor / length;
  }
  section.profile = profile.ends;
  section.spring = profile.spring;
  if (section.spring) {
    section.spring->volume *= length * square;
    section.spring->inertia *= context.transform(block).mass_factor * square;
    section.spring->cable_area *= square;
    section.spring->cable_offset *= length;
    section.spring->scoor = card.real("scoor");
  }
  if (!section.profile) return;
  for (auto* sides : {&section.profile->s, &section.profile->t})
    for (double& side : *sides) side *= length;
  section.profile->line_mass = card.real("nsm") * context.transform(block).mass_factor / length;
  if (card.integer("qr/irid") != 0) section.profile->rule = card.integer("qr/irid");
  if (card.real("shrf") != 0) section.profile->shear_factor = card.real("shrf");
}

}  // namespace

void read_section_shell(Context& context, const Block& block, const Options& options) {
  const CardLayout& card1 = keyword::card_layout("SECTION_SHELL", "card1");
  const CardLayout& card2 = keyword::card_layout("SECTION_SHELL", "card2");
  const CardLayout& user = keyword::card_layout("SECTION_SHELL", "card4");
  const bool one_only = options.any({"EFG", "THERMAL", "XFEM"});
  for_each_section(context, block, options, card1, [&](CardReader& reader) {
    const Card card = reader.next(card1);
    Section section = begin_section(block, card, SectionKind::shell);
    if (card.integer("nip") != 0) section.nip = card.integer("nip");
    section.rule = card.integer("qr/irid");
    if (card.real("shrf") != 0) section.shrf = card.real("shrf");
    const Card values = reader.next(card2);
    if (!values.present())
      context.error(section.place, fmt::format("section {} has no card with thicknesses", section.id));
    for (std::size_t i = 0; i < 4; ++i) section.thickness[i] = context.length(block, values.real(i));
    for (std::size_t i = 1; i < 4; ++i)
      if (section.thickness[i] == 0) section.thickness[i] = section.thickness[0];
    section.nloc = values.real("nloc");
    if (options.has("MISC")) reader.skip();
    if (card.integer("icomp") == 1) {
      const std::int64_t points = card.integer("nip");
      skip_lines(reader, lines_of_eight(points == 0 ? 2 : points));
    }
    if (user_defined(section.elform)) {
      const Card sizes = reader.next(user);
      skip_lines(reader, sizes.integer("nipp"));
      skip_lines(reader, lines_of_eight(sizes.integer("lmc")));
    }
    if (one_only) skip_lines(reader, std::numeric_limits<std::int64_t>::max());
    add_section(context, section);
  });
}

void read_integration_shell(Context& context, const Block& block, const Options&) {
  const CardLayout& card1 = keyword::card_layout("INTEGRATION_SHELL", "card1");
  const CardLayout& card2 = keyword::card_layout("INTEGRATION_SHELL", "card2");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(card1);
    ShellRule rule;
    rule.count = card.integer("nip");
    rule.equal = card.integer("esop");
    rule.failure = card.integer("failopt");
    rule.place = Context::place(block, card.line());
    for (std::int64_t i = 0; rule.equal != 1 && i < rule.count && !reader.at_end(); ++i) {
      const Card point = reader.next(card2);
      rule.points.push_back({point.real("s"), point.real("wf"), point.integer("pid")});
    }
    const auto [entry, is_new] = context.model.shell_rules.try_emplace(card.integer("irid"), std::move(rule));
    if (!is_new)
      context.duplicate("integration rule", entry->first, entry->second.place, Context::place(block, card.line()));
  }
}

void read_section_solid(Context& context, const Block& block, const Options& options) {
  const CardLayout& card1 = keyword::card_layout("SECTION_SOLID", "card1");
  const CardLayout& user = keyword::card_layout("SECTION_SOLID", "card2");
  const bool one_only = options.any({"EFG", "MISC", "PERI", "SPG"});
  for_each_section(context, block, options, card1, [&](CardReader& reader) {
    const Section section = begin_section(block, reader.next(card1), SectionKind::solid);
    if (user_defined(section.elform)) {
      const Card sizes = reader.next(user);
      skip_lines(reader, sizes.integer("nip"));
      skip_lines(reader, lines_of_eight(sizes.integer("lmc")));
    }
    if (one_only) skip_lines(reader, std::numeric_limits<std::int64_t>::max());
    add_section(context, section);
  });
}

void read_section_thick_shell(Context& context, const Block& block, const Options& options) {
  const CardLayout& card1 = keyword::card_layout("SECTION_TSHELL", "card1");
  for_each_section(context, block, options, card1, [&](CardReader& reader) {
    const Card card = reader.next(card1);
    if (card.integer("icomp") == 1) skip_lines(reader, lines_of_eight(card.integer("nip")));
    Section section = begin_section(block, card, SectionKind::thick_shell);
    if (card.integer("nip") != 0) section.nip = card.integer("nip");
    if (card.real("shrf") != 0) section.shrf = card.real("shrf");
    add_section(context, section);
  });
}

void read_section_beam(Context& context, const Block& block, const Options& options) {
  const CardLayout& card1 = keyword::card_layout("SECTION_BEAM", "card1");
  for_each_section(context, block, options, card1, [&](CardReader& reader) {
    const Card card = reader.next(card1);
    Section section = begin_section(block, card, SectionKind::beam);
    if (section.elform == 0) section.elform = 1;
    const Profile profile = read_profile(context, reader, section.elform, card.integer("cst"));
    set_beam(context, block, profile, card, section);
    if (section.spring) note_system(context, section.spring->system);
    add_section(context, section);
  });
}

void read_section_discrete(Context& context, const Block& block, const Options& options) {
  const CardLayout& card1 = keyword::card_layout("SECTION_DISCRETE", "card1");
  for_each_section(context, block, options, card1, [&](CardReader& reader) {
    const Card card = reader.next(card1);
    Section section = begin_section(block, card, SectionKind::discrete);
    section.torsional = card.integer("dro") == 1;
    const Card limits = reader.next(keyword::card_layout("SECTION_DISCRETE", "card2"));
    for (const std::string_view field : {"kd", "v0", "cl", "fd"})
      if (card.real(field) != 0) section.limited = true;
    if (limits.real("cdl") != 0 || limits.real("tdl") != 0) section.limited = true;
    add_section(context, section);
  });
}

void read_section_particle(Context& context, const Block& block, const Options& options) {
  static const CardLayout card1 = [] {
    CardLayout layout = id_and_reals(IdKind::other, 7);
    layout.fields[0].name = "secid";
    return layout;
  }();
  for_each_section(context, block, options, card1, [&](CardReader& reader) {
    const Section section = begin_section(block, reader.next(card1), SectionKind::particle);
    if (options.any({"ELLIPSE", "USER"})) reader.skip();
    add_section(context, section);
  });
}

void read_section_other(Context& context, const Block& block, const Options& options) {
  static const CardLayout card1 = [] {
    CardLayout layout = id_and_reals(IdKind::other, 0);
    layout.fields[0].name = "secid";
    return layout;
  }();
  // Only the id is used: parts refer to it. Only the seatbelts' section is known to be a single repeated line.
  const bool repeats = options.has("SEATBELT");
  for_each_section(context, block, options, card1, [&](CardReader& reader) {
    add_section(context, begin_section(block, reader.next(card1), SectionKind::other));
    if (!repeats) skip_lines(reader, std::numeric_limits<std::int64_t>::max());
  });
}

}  // namespace gapcheck::model
