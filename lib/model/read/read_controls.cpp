#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "model/read/context.hpp"
#include "model/read/field_values.hpp"

namespace gapcheck::model {
namespace {

/// The next card, or a blank one if the block has ended.
Card next_card(CardReader& reader, std::string_view keyword, std::string_view card) {
  return reader.next(keyword::card_layout(keyword, card));
}

/// Metres in a unit of length by its name; 0: not a known name.
double metres_in(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, double>, 6> units{
      {{"", 1}, {"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}}};
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  for (const auto& [unit, metres] : units)
    if (std::equal(name.begin(), name.end(), unit.begin(), unit.end(), same)) return metres;
  return 0;
}

}  // namespace

void read_control_contact(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  Controls& controls = context.model.controls;
  controls.contact_given = true;
  controls.contact_place = Context::place(block, block.line);
  const Card card1 = next_card(reader, "CONTROL_CONTACT", "card1");
  controls.slsfac = or_default(card1.real("slsfac"), 0.1);
  controls.rwpnal = card1.real("rwpnal");
  controls.shlthk = card1.integer("shlthk");
  controls.penopt = or_default(card1.integer("penopt"), 1);
  controls.enmass = card1.integer("enmass");
  controls.orien = or_default(card1.integer("orien"), 1);
  const Card card2 = next_card(reader, "CONTROL_CONTACT", "card2");
  controls.xpene = or_default(card2.real("xpene"), 4);
  controls.ssthk = card2.integer("ssthk");
  controls.ecdt = card2.integer("ecdt");
  controls.tiedprj = card2.integer("tiedprj");
  const Card card3 = next_card(reader, "CONTROL_CONTACT", "card3");
  controls.sfric = card3.real("sfric");
  controls.dfric = card3.real("dfric");
  controls.vfc = context.stress(block, card3.real("vfc"));
  controls.th = context.length(block, card3.real("th"));
  controls.th_sf = card3.real("th_sf");
  const Card card4 = next_card(reader, "CONTROL_CONTACT", "card4");
  controls.ignore = card4.integer("ignore");
  context.spot_thinning = card4.real("spothin");
  context.spot_thinning_place = Context::place(block, card4.line());
  if (card4.integer("frceng") == 1)
    context.model.output.notes.push_back(
        {Context::place(block, card4.line()),
         "*CONTROL_CONTACT: FRCENG = 1: sleout has the friction energy of each contact; "
         "intfor does not have it by segment, since its layout is not published"});
  reader.skip();
  const Card card6 = next_card(reader, "CONTROL_CONTACT", "card6");
  controls.shledg = card6.integer("shledg");
  controls.ftall = card6.integer("ftall");
}

void read_control_shell(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  Controls& controls = context.model.controls;
  controls.shell_given = true;
  controls.shell_place = Context::place(block, block.line);
  const Card card1 = next_card(reader, "CONTROL_SHELL", "card1");
  controls.istupd = card1.integer("istupd");
  controls.shell_esort = card1.integer("esort");
  controls.shell_normals = card1.integer("irnxx");
  controls.shell_theory = or_default(card1.integer("theory"), 2);
  controls.bwc = or_default(card1.integer("bwc"), 2);
  controls.proj = card1.integer("proj");
  controls.intgrd = next_card(reader, "CONTROL_SHELL", "card2").integer("intgrd");
  const Card card3 = next_card(reader, "CONTROL_SHELL", "card3");
  controls.cntco = card3.integer("cntco");
  controls.pstupd = card3.integer("pstupd");
  controls.sidt4tu = card3.integer("sidt4tu");
  const Card card4 = next_card(reader, "CONTROL_SHELL", "card4");
  controls.nfail1 = card4.integer("nfail1");
  controls.nfail4 = card4.integer("nfail4");
  controls.psnfail = card4.integer("psnfail");
  controls.drcpsid = card4.integer("drcpsid");
}

void read_control_solid(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = next_card(reader, "CONTROL_SOLID", "card1");
  Controls& controls = context.model.controls;
  controls.solid_esort = card.integer("esort");
  controls.psfail = card.integer("psfail");
  controls.solid_place = Context::place(block, card.line());
}

void read_control_solution(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  context.model.controls.lcint = next_card(reader, "CONTROL_SOLUTION", "card1").integer("lcint");
}

void read_control_relaxation(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = next_card(reader, "CONTROL_DYNAMIC_RELAXATION", "card1");
  Controls& controls = context.model.controls;
  controls.idrflg = card.integer("idrflg");
  if (const std::int64_t cycles = card.integer("nrcyck"); cycles != 0) controls.nrcyck = cycles;
  controls.irelal = card.integer("irelal");
  controls.drtol = or_default(card.real("drtol"), 0.001);
  controls.drfctr = or_default(card.real("drfctr"), 0.995);
  controls.drterm = card.real("drterm") * context.transform(block).time_factor;
  controls.tssfdr = card.real("tssfdr");
  controls.relaxation_place = Context::place(block, block.line);
}

void read_control_timestep(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = next_card(reader, "CONTROL_TIMESTEP", "card1");
  Controls& controls = context.model.controls;
  controls.tssfac = or_default(card.real("tssfac"), 0.9);
  controls.isdo = card.integer("isdo");
  controls.dt2ms = card.real("dt2ms") * context.transform(block).time_factor;
  controls.dtinit = card.real("dtinit") * context.transform(block).time_factor;
  controls.tslimt = card.real("tslimt");
  controls.ms1st = card.integer("ms1st");
  controls.lctm = card.integer("lctm");
  controls.erode = card.integer("erode");
  controls.timestep_place = Context::place(block, block.line);
}

void read_control_units(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const double named = metres_in(next_card(reader, "CONTROL_UNITS", "card1").text("length"));
  const double given = next_card(reader, "CONTROL_UNITS", "card2").real("length_scale");
  context.model.controls.length_unit = (given > 0 ? given : named) / context.length(block, 1);
}

void read_control_termination(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = next_card(reader, "CONTROL_TERMINATION", "card1");
  Controls& controls = context.model.controls;
  controls.endtim = card.real("endtim") * context.transform(block).time_factor;
  controls.endcyc = card.integer("endcyc");
  controls.dtmin = card.real("dtmin");
  controls.endeng = card.real("endeng");
}

void read_hourglass(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (options.has("TITLE")) reader.skip();
    if (reader.at_end()) break;
    if (skip_blank(reader)) continue;
    const Card card = next_card(reader, "HOURGLASS", "card1");
    const HourglassControl control{card.integer("ihq"),
                                   card.real("qm"),
                                   card.real("q1"),
                                   card.real("q2"),
                                   card.real("qb/vdc"),
                                   card.real("qw"),
                                   Context::place(block, card.line())};
    const auto [entry, is_new] = context.model.hourglass.try_emplace(card.integer("hgid"), control);
    if (!is_new) context.duplicate("hourglass control", entry->first, entry->second.place, control.place);
  }
}

void read_control_hourglass(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = next_card(reader, "CONTROL_HOURGLASS", "card1");
  Controls& controls = context.model.controls;
  controls.ihq = card.integer("ihq");
  controls.qh = card.real("qh");
  controls.hourglass_place = Context::place(block, block.line);
}

void read_control_bulk_viscosity(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = next_card(reader, "CONTROL_BULK_VISCOSITY", "card1");
  Controls& controls = context.model.controls;
  controls.bulk_q1 = or_default(card.real("q1"), 1.5);
  controls.bulk_q2 = or_default(card.real("q2"), 0.06);
  controls.bulk_type = or_default(card.integer("type"), 1);
  controls.bulk_beams = card.integer("btype");
  controls.bulk_tshells = card.integer("tstype");
  controls.bulk_place = Context::place(block, block.line);
}

void read_control_accuracy(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = next_card(reader, "CONTROL_ACCURACY", "card1");
  Controls& controls = context.model.controls;
  controls.osu = card.integer("osu");
  controls.inn = or_default(card.integer("inn"), 1);
  controls.pidosu = card.integer("pidos");
  controls.accuracy_place = Context::place(block, block.line);
}

}  // namespace gapcheck::model
