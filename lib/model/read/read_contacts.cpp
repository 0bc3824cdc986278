#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "base/number.hpp"
#include "model/contact/contact_cards.hpp"
#include "model/contact/contact_name.hpp"
#include "model/read/context.hpp"
#include "model/read/field_values.hpp"

namespace gapcheck::model {
namespace {

using keyword::IdKind;

IdKind id_kind(std::int64_t surface_type) {
  switch (static_cast<SurfaceType>(surface_type)) {
    case SurfaceType::part:
      return IdKind::part;
    case SurfaceType::all:
      return IdKind::plain;
    default:
      return IdKind::set;
  }
}

SurfaceInput read_surface(Context& context, const Block& block, const Card& card, std::string_view id,
                          std::string_view type, std::string_view box) {
  SurfaceInput surface;
  surface.type = card.integer(type);
  surface.id = context.with_offset(block, id_kind(surface.type), card.integer(id));
  surface.box = card.integer(box);
  surface.given = !card.blank(id) || !card.blank(type);
  return surface;
}

/// The line of the next card; 0 if the block has ended.
std::uint32_t line_of_next(const CardReader& reader) { return reader.at_end() ? 0 : reader.peek_line(); }

/// True if the block continues; otherwise notes the first mandatory card that it ends before.
bool has_card(const CardReader& reader, Contact& contact, std::string_view card) {
  if (!reader.at_end()) return true;
  if (contact.cards.missing.empty()) contact.cards.missing = card;
  return false;
}

void skip_cards(CardReader& reader, Contact& contact, std::string_view card, std::int64_t count) {
  for (; count > 0 && has_card(reader, contact, card); --count) reader.skip();
}

void read_mpp(CardReader& reader, Contact& contact) {
  if (!has_card(reader, contact, "the MPP card")) return;
  contact.lines.mpp = line_of_next(reader);
  const Card card = reader.next(contact_card_layout("MPP1"));
  if (!card.blank("ignore")) contact.mpp_ignore = card.integer("ignore");
  contact.mpp_cparm8 = card.integer("cparm8");
  contact.parmax = card.real("parmax");
  if (trimmed(reader.peek()).starts_with('&')) reader.skip();
}

void read_times(const Card& card2, double time_factor, Contact& contact) {
  // DT = -9999 is not a time and makes BT the number of a curve.
  const double death = card2.real("dt");
  const double factor = death == curve_of_times ? 1 : time_factor;
  contact.birth = card2.real("bt") * factor;
  contact.death = or_default(death * factor, contact.death);
}

/// Cards 1 to 3. Card 1 is required; without the others the solver's defaults apply.
bool read_mandatory(Context& context, CardReader& reader, Contact& contact) {
  const Block& block = reader.block();
  const bool transducer = contact.kind->code == ContactCode::transducer;
  contact.cards.any = has_card(reader, contact, "card 1 (SURFA, SURFB)");
  if (!contact.cards.any) {
    context.error(contact.place,
                  fmt::format("*{} ends before {}; add the card", contact.written, contact.cards.missing));
    return false;
  }
  contact.lines.card1 = line_of_next(reader);
  const Card card1 = reader.next(contact_card_layout("card1"));
  contact.a = read_surface(context, block, card1, "surfa", "surfatyp", "saboxid");
  contact.b = read_surface(context, block, card1, "surfb", "surfbtyp", "sbboxid");
  contact.print_a = card1.integer("sapr") != 0;
  contact.print_b = card1.integer("sbpr") != 0;
  // A transducer needs neither friction nor stiffness.
  if (!transducer) has_card(reader, contact, "card 2 (friction, birth and death)");
  contact.lines.card2 = line_of_next(reader);
  const Card card2 = reader.next(contact_card_layout("card2"));
  if (!transducer) has_card(reader, contact, "card 3 (stiffness and thickness)");
  contact.lines.card3 = line_of_next(reader);
  const Card card3 = reader.next(contact_card_layout("card3"));
  // Of TIED_..._FAILURE the tension and the shear at which ties fail.
  const double strengths = contact.kind->tie == TieForm::with_failure ? context.stress(block, 1) : 1;
  contact.fs = card2.real("fs") * strengths;
  contact.fd = card2.real("fd") * strengths;
  contact.dc = context.decay(block, card2.real("dc"));
  contact.vc = context.stress(block, card2.real("vc"));
  contact.vdc = card2.real("vdc");
  contact.penchk = card2.integer("penchk");
  read_times(card2, context.transform(block).time_factor, contact);
  contact.sfs = or_default(card3.real("sfsa"), 1);
  contact.sfm = or_default(card3.real("sfsb"), 1);
  contact.sst = context.length(block, card3.real("sast"));
  contact.mst = context.length(block, card3.real("sbst"));
  contact.sfst = or_default(card3.real("sfsat"), 1);
  contact.sfmt = or_default(card3.real("sfsbt"), 1);
  contact.fsf = or_default(card3.real("fsf"), 1);
  contact.vsf = or_default(card3.real("vsf"), 1);
  return true;
}

/// The type's first own card is required, and must look like one.
void check_type_card(const CardReader& reader, Contact& contact) {
  const keyword::CardLayout* card = type_card(contact.kind->cards);
  if (card == nullptr || !has_card(reader, contact, card_words(*card)) || has_form(reader, *card)) return;
  contact.cards.misread = reader.peek_line();
  contact.cards.expected = card_words(*card);
}

void read_eroding(const Card& card, Contact& contact) {
  contact.symmetry_faces = card.integer("isym");
  contact.erosop = card.integer("erosop");
  contact.iadj = card.integer("iadj");
}

void read_interference(const Card& card, Contact& contact) {
  contact.interference_curve_relaxation = card.integer("lcid1");
  contact.interference_curve = card.integer("lcid2");
}

/// OPTION and the strengths of *CONTACT_AUTOMATIC_…_TIEBREAK.
void read_tiebreak(Context& context, CardReader& reader, Contact& contact) {
  const auto& units = context.transform(reader.block());
  const double stress = context.stress(reader.block(), 1);
  const Card card = reader.next(*type_card(TypeCards::tiebreak));
  contact.tiebreak_option = card.integer("option");
  const bool linear_damage = contact.tiebreak_option == 6 || contact.tiebreak_option == 8;
  TiebreakStrength& strength = contact.tiebreak;
  strength.normal = card.real("nfls") * stress;
  strength.shear = card.real("sfls") * stress;
  strength.param = card.real("param") * (linear_damage ? units.length_factor : 1);
  strength.normal_energy = card.real("eraten") * stress * units.length_factor;
  strength.shear_energy = card.real("erates") * stress * units.length_factor;
  strength.stiffness_ratio = or_default(card.real("ct2cn"), strength.stiffness_ratio);
  strength.stiffness = card.real("cn") * stress / units.length_factor;
}

/// Strengths of *CONTACT_TIEBREAK_NODES (forces) and *CONTACT_TIEBREAK_SURFACE (stresses).
void read_old_tiebreak(Context& context, CardReader& reader, Contact& contact) {
  const auto& units = context.transform(reader.block());
  const double force = units.mass_factor * units.length_factor / (units.time_factor * units.time_factor);
  const bool nodes = contact.kind->cards == TypeCards::tiebreak_nodes;
  const Card card = reader.next(*type_card(contact.kind->cards));
  TiebreakStrength& strength = contact.tiebreak;
  if (nodes) {
    strength.normal = card.real("nflf") * force;
    strength.shear = card.real("sflf") * force;
    strength.normal_power = or_default(card.real("nen"), strength.normal_power);
    strength.shear_power = or_default(card.real("mes"), strength.shear_power);
    return;
  }
  const double stress = context.stress(reader.block(), 1);
  strength.normal = card.real("nfls") * stress;
  strength.shear = card.real("sfls") * stress;
  strength.curve = card.integer("tblcid");
  strength.thickness_offsets = card.integer("thkoff") == 1;
}

void read_rigid(Context& context, CardReader& reader, Contact& contact) {
  const auto& units = context.transform(reader.block());
  const double force = units.mass_factor * units.length_factor / (units.time_factor * units.time_factor);
  const Card card = reader.next(*type_card(TypeCards::rigid));
  RigidForce& law = contact.rigid;
  law.curve = card.integer("lcid");
  law.method = card.integer("fcm");
  law.unloading = card.real("us") * force / units.length_factor;
  law.damping_curve = card.integer("lcdc");
  law.damping_scale = or_default(card.real("dsf"), law.damping_scale);
  law.unloading_curve = card.integer("unlcid");
}

bool has_cohesive_law(const Contact& contact) {
  const std::int64_t option = contact.tiebreak_option;
  return option == 13 || option == 14 || option == -13 || option == -14;
}

/// The cards that the type alone has. The filter card (RFILTF) that new versions allow after the cards of a tiebreak
/// cannot be told from card A, and is taken for card A.
void read_type_cards(Context& context, CardReader& reader, Contact& contact) {
  const TypeCards cards = contact.kind->cards;
  check_type_card(reader, contact);
  switch (cards) {
    case TypeCards::none:
      break;
    case TypeCards::eroding:
      if (contact.cards.misread == 0)
        read_eroding(reader.next(*type_card(cards)), contact);
      else
        reader.skip();
      break;
    case TypeCards::interference_card:
      read_interference(reader.next(*type_card(cards)), contact);
      break;
    case TypeCards::rigid:
      read_rigid(context, reader, contact);
      break;
    case TypeCards::constraint:
    case TypeCards::composite:
    case TypeCards::contraction_joint:
    case TypeCards::tied:
      reader.skip();
      break;
    case TypeCards::tiebreak_nodes:
    case TypeCards::tiebreak_surface:
      read_old_tiebreak(context, reader, contact);
      break;
    case TypeCards::tiebreak:
    case TypeCards::tiebreak_damping:
      read_tiebreak(context, reader, contact);
      if (cards == TypeCards::tiebreak_damping) skip_cards(reader, contact, "the damping card (DMP_1)", 1);
      // The tiebreak of mortar contacts has only its option card.
      if (has_cohesive_law(contact) && !(contact.options.mortar && cards == TypeCards::tiebreak))
        skip_cards(reader, contact, "the cards of the cohesive law (G1C_0, G2C_0)", 2);
      break;
    case TypeCards::tiebreak_user:
      contact.tiebreak_option = reader.next(*type_card(cards)).integer("option");
      skip_cards(reader, contact, "the user's cards (UP1 to UP16)", 2);
      break;
    case TypeCards::tied_weld: {
      const std::int64_t parameters = reader.next(*type_card(cards)).integer("ntprm");
      skip_cards(reader, contact, "the weld's parameters (TPRM1)", parameters <= 0 ? 1 : (parameters - 1) / 8 + 1);
      break;
    }
    case TypeCards::draw_bead:
    case TypeCards::draw_bead_initialize:
      skip_cards(reader, contact, "the beads' points (POINT1, POINT2)",
                 reader.next(*type_card(cards)).integer("nbead"));
      if (cards == TypeCards::draw_bead_initialize) skip_cards(reader, contact, "the last card of the draw bead", 1);
      break;
  }
}

/// The cards of the keyword's option words.
void read_option_cards(CardReader& reader, Contact& contact) {
  if (contact.options.thermal) skip_cards(reader, contact, "the THERMAL card", 1);
  if (contact.options.thermal_friction) skip_cards(reader, contact, "the THERMAL_FRICTION card", 1);
  if (contact.options.ortho_friction) skip_cards(reader, contact, "the cards of ORTHO_FRICTION", 4);
}

void read_a(const Card& card, Contact& contact) {
  contact.soft = card.integer("soft");
  contact.sofscl = or_default(card.real("sofscl"), contact.sofscl);
  contact.lcidab = card.integer("lcidab");
  contact.maxpar = card.real("maxpar");
  contact.sbopt = or_default(card.integer("sbopt"), contact.sbopt);
  contact.depth = or_default(card.integer("depth"), contact.depth);
  contact.bsort = card.integer("bsort");
}

void read_b(const Card& card, double length_factor, Contact& contact) {
  // A length in the old types 3, 5, 10 and in mortar contacts, a multiple of the thickness in the others.
  const bool length = contact.options.mortar || contact.kind->family != Family::automatic;
  contact.penmax = card.real("penmax") * (length ? length_factor : 1);
  contact.thkopt = card.integer("thkopt");
  contact.shlthk = card.integer("shlthk");
  contact.snlog = card.integer("snlog");
  contact.isym = card.integer("isym");
  contact.sldthk = card.real("sldthk") * length_factor;
  contact.sldstf = card.real("sldstf");
}

void read_c(const Card& card, const keyword::Transform& units, Contact& contact) {
  contact.igap = or_default(card.integer("igap"), contact.igap);
  if (!card.blank("ignore")) contact.ignore = card.integer("ignore");
  contact.dprfac = card.real("dprfac");
  contact.dtstif = card.real("dtstif");
  if (contact.options.mortar) {
    // MPAR1 is a time where penetrations are pressed out (IGNORE 3 and 4), else a pressure; MPAR2 is a length.
    const std::int64_t ignore =
        std::abs(contact.mpp_ignore.value_or(0) != 0 ? *contact.mpp_ignore : contact.ignore.value_or(0));
    const double pressure = units.mass_factor / (units.length_factor * units.time_factor * units.time_factor);
    if (contact.dprfac > 0) contact.dprfac *= ignore == 3 || ignore == 4 ? units.time_factor : pressure;
    contact.dtstif *= units.length_factor;
  } else if (contact.dtstif > 0) {
    contact.dtstif *= units.time_factor;  // below zero not a time
  }
}

void read_d(const Card& card, Contact& contact) {
  contact.dtpchk = card.real("dtpchk");
  contact.tcso = card.integer("tcso");
  contact.tiedid = card.integer("tiedid");
  contact.shledg = card.integer("shledg");
}

void read_e(const Card& card, Contact& contact) {
  contact.sharec = card.integer("sharec");
  contact.cparm8 = card.integer("cparm8");
  contact.ipback = card.integer("ipback");
  contact.srnde = card.integer("srnde");
}

/// Cards A to G, as many as there are; blank lines are cards.
void read_optional(Context& context, CardReader& reader, Contact& contact) {
  constexpr std::string_view names[] = {"A", "B", "C", "D", "E", "F", "G"};
  contact.lines.last = reader.last_line();
  for (const std::string_view name : names) {
    if (reader.at_end()) return;
    if (contact.optional_cards < contact.lines.optional.size())
      contact.lines.optional[contact.optional_cards] = contact.lines.last = reader.peek_line();
    ++contact.optional_cards;
    const Card card = reader.next(contact_card_layout(name));
    switch (name.front()) {
      case 'A':
        read_a(card, contact);
        break;
      case 'B':
        read_b(card, context.transform(reader.block()).length_factor, contact);
        break;
      case 'C':
        read_c(card, context.transform(reader.block()), contact);
        break;
      case 'D':
        read_d(card, contact);
        break;
      case 'E':
        read_e(card, contact);
        break;
      case 'F':
        contact.ignroff = card.integer("ignroff");
        break;
      case 'G':
        contact.shloff = card.real("shloff");
        break;
      default:
        break;
    }
  }
}

/// Lines after the last card; blank ones do no harm.
void count_surplus(CardReader& reader, Contact& contact) {
  CardLines& cards = contact.cards;
  for (; !reader.at_end(); reader.skip()) {
    if (trimmed(reader.peek()).empty()) continue;
    if (cards.surplus++ == 0) cards.first_surplus = reader.peek_line();
  }
}

void read_exclusion(Context& context, const Block& block) {
  const auto& first = keyword::card_layout(exclusion_keyword, "card1");
  const auto& row = keyword::card_layout(exclusion_keyword, "card2");
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = reader.next(first);
  ContactExclusion exclusion;
  exclusion.place = Context::place(block, card.present() ? card.line() : block.line);
  exclusion.contact = card.integer("cid");
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card pair = reader.next(row);
    ContactExclusion::Pair sides;
    sides.type_a = pair.integer("typea");
    sides.type_b = pair.integer("typeb");
    sides.a = context.with_offset(block, id_kind(sides.type_a), pair.integer("sida"));
    sides.b = context.with_offset(block, id_kind(sides.type_b), pair.integer("sidb"));
    exclusion.pairs.push_back(sides);
  }
  context.model.exclusions.push_back(std::move(exclusion));
}

}  // namespace

void read_contact(Context& context, const Block& block, const Options&) {
  if (block.name.starts_with(exclusion_keyword)) return read_exclusion(context, block);
  Contact contact;
  set_name(block.name, contact);
  contact.place = Context::place(block, block.line);
  if (!parse_contact_name(block.name).modifier) contact.order = ++context.interfaces;
  CardReader reader(context.deck, block, context.diagnostics);
  if (contact.options.id) {
    const Card card = reader.next(contact_card_layout("ID"));
    contact.id = ContactId(card.integer("cid"));
    contact.title = card.text("heading");
  }
  if (contact.kind != nullptr) {
    if (contact.options.mpp) read_mpp(reader, contact);
    if (read_mandatory(context, reader, contact)) {
      read_type_cards(context, reader, contact);
      read_option_cards(reader, contact);
      read_optional(context, reader, contact);
      count_surplus(reader, contact);
    }
  }
  std::vector<Contact>& contacts = context.model.contacts;
  if (contacts.empty()) {
    // Contacts are large: growing a list of many would take twice its memory.
    const auto& blocks = context.deck.blocks();
    contacts.reserve(static_cast<std::size_t>(std::count_if(
        blocks.begin(), blocks.end(), [](const Block& each) { return each.name.starts_with("CONTACT"); })));
  }
  contacts.push_back(std::move(contact));
}

}  // namespace gapcheck::model
