#include <algorithm>

#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

using keyword::card_layout;

double scale_of(const Card& card) { return card.real("sf") == 0 ? 1 : card.real("sf"); }

/// Visits each card of a block's only layout; blank lines between them are skipped.
template <class Visit>
void for_each_card(Context& context, const Block& block, const keyword::CardLayout& layout, bool with_id,
                   const Visit& visit) {
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    if (with_id) reader.skip();
    if (reader.at_end()) break;
    visit(reader, reader.next(layout));
  }
}

/// Force per unit of the block's file.
double force_unit(const keyword::Transform& units) {
  return units.mass_factor * units.length_factor / (units.time_factor * units.time_factor);
}

double pressure_unit(const keyword::Transform& units) {
  return force_unit(units) / (units.length_factor * units.length_factor);
}

}  // namespace

void read_concentrated_load(Context& context, const Block& block, const Options&) {
  const bool rigid = block.name == "LOAD_RIGID_BODY", set = block.name == "LOAD_NODE_SET";
  const auto& layout = rigid ? card_layout("LOAD_RIGID_BODY", "card1")
                       : set ? card_layout("LOAD_NODE_SET", "card1")
                             : card_layout("LOAD_NODE_POINT", "card1");
  const keyword::Transform& units = context.transform(block);
  for_each_card(context, block, layout, false, [&](CardReader&, const Card& card) {
    ConcentratedLoad load;
    load.keyword = block.name;
    load.rigid = rigid;
    if (rigid)
      load.part = card.integer("pid");
    else
      load.nodes = {card.integer(set ? "nsid" : "nid"), set};
    load.freedom = card.integer("dof");
    load.curve = card.integer("lcid");
    load.scale = scale_of(card) * force_unit(units) * (load.freedom > 4 ? units.length_factor : 1);
    load.system = card.integer("cid");
    note_system(context, load.system);
    load.followed = {card.integer("m1"), card.integer("m2"), card.integer("m3")};
    load.place = Context::place(block, card.line());
    context.model.loads.concentrated.push_back(std::move(load));
  });
}

void read_segment_load(Context& context, const Block& block, const Options& options) {
  const bool set = block.name.starts_with("LOAD_SEGMENT_SET");
  const auto& layout = set ? card_layout("LOAD_SEGMENT_SET", "card1") : card_layout("LOAD_SEGMENT", "card1");
  const keyword::Transform& units = context.transform(block);
  for_each_card(context, block, layout, options.has("ID"), [&](CardReader& reader, const Card& card) {
    PressureLoad load;
    load.kind = set ? PressureLoad::Kind::segment_set : PressureLoad::Kind::segment;
    load.keyword = block.name;
    if (set)
      load.id = card.integer("ssid");
    else
      load.nodes = {card.integer("n1"), card.integer("n2"), card.integer("n3"), card.integer("n4")};
    load.curve = card.integer("lcid");
    load.scale = scale_of(card) * pressure_unit(units);
    load.arrival = card.real("at") * units.time_factor;
    load.place = Context::place(block, card.line());
    // Further nodes of higher-order segments are on a separate line.
    if (!set && card.integer("n5") != 0) reader.skip();
    context.model.loads.pressures.push_back(std::move(load));
  });
}

void read_shell_load(Context& context, const Block& block, const Options& options) {
  const bool set = block.name.starts_with("LOAD_SHELL_SET");
  const auto& layout = set ? card_layout("LOAD_SHELL_SET", "card1") : card_layout("LOAD_SHELL_ELEMENT", "card1");
  const keyword::Transform& units = context.transform(block);
  for_each_card(context, block, layout, options.has("ID"), [&](CardReader&, const Card& card) {
    PressureLoad load;
    load.kind = set ? PressureLoad::Kind::shell_set : PressureLoad::Kind::shell;
    load.keyword = block.name;
    load.id = card.integer(set ? "esid" : "eid");
    load.curve = card.integer("lcid");
    load.scale = scale_of(card) * pressure_unit(units);
    load.arrival = card.real("at") * units.time_factor;
    load.place = Context::place(block, card.line());
    context.model.loads.pressures.push_back(std::move(load));
  });
}

void read_airbag(Context& context, const Block& block, const Options& options) {
  constexpr std::string_view gas = "AIRBAG_SIMPLE_AIRBAG_MODEL", by_volume = "AIRBAG_SIMPLE_PRESSURE_VOLUME";
  const keyword::Transform& units = context.transform(block);
  const double area = units.length_factor * units.length_factor, heat = area / (units.time_factor * units.time_factor);
  CardReader reader(context.deck, block, context.diagnostics);
  Airbag airbag;
  airbag.keyword = block.name;
  airbag.kind = block.name.starts_with(gas) ? Airbag::Kind::simple : Airbag::Kind::pressure_volume;
  airbag.id = static_cast<std::int64_t>(context.model.airbags.size()) + 1;
  if (options.has("ID")) {
    const Card card = reader.next(card_layout(gas, "ID"));
    if (card.integer("id") != 0) airbag.id = card.integer("id");
    airbag.title = card.text("title");
  }
  const Card card = reader.next(card_layout(gas, "card1"));
  if (!card.present()) return;
  const auto factor = [&](std::string_view field) { return card.real(field) == 0 ? 1 : card.real(field); };
  const auto constant_or_curve = [&](double value, double& constant, std::int64_t& curve) {
    constant = std::max(value, 0.0);
    if (value < 0) curve = context.curve_id(block, -value);
  };
  airbag.place = Context::place(block, card.line());
  airbag.set = card.integer("sid");
  airbag.parts = card.integer("sidtyp") != 0;
  airbag.sensor = card.integer("rbid");
  airbag.volume_scale = factor("vsca");
  airbag.pressure_scale = factor("psca");
  airbag.excluded = card.real("vini") * area * units.length_factor;
  airbag.damping = card.real("mwd");
  airbag.stagnation = card.real("spsf");
  airbag.pressure_unit = pressure_unit(units);
  airbag.flow_unit = units.mass_factor / units.time_factor;
  airbag.area_unit = area;
  if (airbag.kind == Airbag::Kind::pressure_volume) {
    const Card law = reader.next(card_layout(by_volume, "card2"));
    constant_or_curve(law.real("cn"), airbag.coefficient, airbag.coefficient_curve);
    airbag.coefficient *= airbag.pressure_unit;
    airbag.factor = law.real("beta");
    airbag.curve = law.integer("lcid");
  } else {
    const Card law = reader.next(card_layout(gas, "card2")), more = reader.next(card_layout(gas, "card3"));
    airbag.heat_volume = law.real("cv") * heat;
    airbag.heat_pressure = law.real("cp") * heat;
    airbag.temperature = law.real("t");
    airbag.curve = law.integer("lcid");
    constant_or_curve(law.real("mu"), airbag.shape, airbag.shape_curve);
    constant_or_curve(law.real("area"), airbag.area, airbag.area_curve);
    airbag.area *= area;
    airbag.pressure = law.real("pe") * airbag.pressure_unit;
    airbag.density = law.real("ro") * units.mass_factor / (area * units.length_factor);
    airbag.exit_curve = more.integer("lou");
  }
  context.model.airbags.push_back(std::move(airbag));
}

void read_body_load(Context& context, const Block& block, const Options&) {
  const keyword::Transform& units = context.transform(block);
  for_each_card(context, block, card_layout("LOAD_BODY_X", "card1"), false, [&](CardReader& reader, const Card& card) {
    BodyLoad load;
    load.keyword = block.name;
    load.by_vector = block.name == "LOAD_BODY_VECTOR";
    load.rotation = block.name.starts_with("LOAD_BODY_R");
    if (load.by_vector) {
      const Card vector = reader.next(card_layout("LOAD_BODY_VECTOR", "card2"));
      load.direction = {vector.real("v1"), vector.real("v2"), vector.real("v3")};
    } else {
      load.axis = block.name.back() - 'X';
    }
    load.curve = card.integer("lcid");
    load.relaxation_curve = card.integer("lciddr");
    load.scale = scale_of(card) / units.time_factor;
    if (!load.rotation) load.scale *= units.length_factor / units.time_factor;
    if (load.rotation)
      load.center = units.apply(units.length_factor * Vector(card.real("xc"), card.real("yc"), card.real("zc")));
    load.system = card.integer("cid");
    load.place = Context::place(block, card.line());
    context.model.loads.bodies.push_back(std::move(load));
  });
}

void read_body_load_parts(Context& context, const Block& block, const Options&) {
  for_each_card(context, block, card_layout("LOAD_BODY_PARTS", "card1"), false, [&](CardReader&, const Card& card) {
    context.model.loads.body_parts.push_back({card.integer("psid"), Context::place(block, card.line())});
  });
}

void read_global_damping(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  const Card card = reader.next(card_layout("DAMPING_GLOBAL", "card1"));
  if (!card.present()) return;
  GlobalDamping damping;
  damping.curve = card.integer("lcid");
  damping.scale = 1 / context.transform(block).time_factor;
  damping.value = card.real("valdmp") * damping.scale;
  for (std::size_t i = 0; i < 6; ++i) damping.factors[i] = card.real(2 + i);
  if (std::all_of(damping.factors.begin(), damping.factors.end(), [](double factor) { return factor == 0; }))
    damping.factors.fill(1);
  damping.place = Context::place(block, card.line());
  context.model.loads.damping = damping;
}

void read_part_damping(Context& context, const Block& block, const Options& options) {
  const bool set = options.has("SET");
  const double rate = 1 / context.transform(block).time_factor;
  for_each_card(context, block, card_layout("DAMPING_PART_MASS", set ? "sets" : "card1"), false,
                [&](CardReader& reader, const Card& card) {
                  PartDamping damping;
                  damping.keyword = block.name;
                  damping.set = set;
                  damping.id = card.integer("pid");
                  damping.curve = card.integer("lcid");
                  damping.scale = (card.real("sf") == 0 ? 1 : card.real("sf")) * rate;
                  damping.place = Context::place(block, card.line());
                  damping.factors.fill(1);
                  if (card.integer("flag") == 1) {
                    const Card factors = reader.next(card_layout("DAMPING_PART_MASS", "card2"));
                    for (std::size_t i = 0; i < 6; ++i) damping.factors[i] = factors.real(i);
                  }
                  context.model.loads.part_dampings.push_back(std::move(damping));
                });
}

void read_relative_damping(Context& context, const Block& block, const Options&) {
  for_each_card(context, block, card_layout("DAMPING_RELATIVE", "card1"), false, [&](CardReader&, const Card& card) {
    RelativeDamping damping;
    damping.fraction = card.real("cdamp");
    damping.frequency = card.real("freq") / context.transform(block).time_factor;
    damping.body = card.integer("pidrb");
    damping.part_set = card.integer("psid");
    damping.squared = card.real("dv2");
    damping.curve = card.integer("lcid");
    damping.place = Context::place(block, card.line());
    context.model.loads.relative_dampings.push_back(damping);
  });
}

}  // namespace gapcheck::model
