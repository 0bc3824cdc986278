#include <array>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"
#include "model/read/field_values.hpp"

namespace gapcheck::model {
namespace {

constexpr std::size_t small_width = 10, large_width = 16;

/// Reads the cards of one block, element by element.
class StressReader {
 public:
  StressReader(Context& context, const Block& block, bool shells, bool set)
      : reader_(context.deck, block, context.diagnostics),
        first_(keyword::card_layout(shells ? set ? "INITIAL_STRESS_SHELL_SET" : "INITIAL_STRESS_SHELL"
                                    : set  ? "INITIAL_STRESS_SOLID_SET"
                                           : "INITIAL_STRESS_SOLID",
                                    "card1")),
        shells_(shells),
        set_(set),
        stress_(context.stress(block, 1)),
        turned_(context.transform(block).places && !context.transform(block).matrix.isIdentity()) {}

  [[nodiscard]] bool at_end() const { return reader_.at_end(); }
  bool skip_blank() { return model::skip_blank(reader_); }

  InitialStress next() {
    using Kind = InitialStress::Kind;
    const Card card = reader_.next(first_);
    InitialStress one;
    one.kind = shells_ ? set_ ? Kind::shell_set : Kind::shell : set_ ? Kind::solid_set : Kind::solid;
    one.id = card.integer(set_ ? "sid" : "eid");
    one.in_plane = card.integer(shells_ ? "nplane" : "nint");
    if (shells_) one.layers = card.integer("nthick");
    one.history = card.integer("nhisv");
    one.tensors = card.integer("ntensr");
    one.large = card.integer("large");
    one.volume_flag = card.integer("iveflg");
    one.group = card.integer("ialegp");
    one.thermal = card.integer("nthint") != 0 && card.integer("nthhsv") != 0 ? 1 : 0;
    one.turned = turned_;
    one.place = Context::place(reader_.block(), card.line());
    if (!one.readable()) return one;
    const std::int64_t count = one.in_plane * one.layers;
    while (static_cast<std::int64_t>(one.points.size()) < count && read_point(one)) {
    }
    return one;
  }

 private:
  /// False where the block ends before.
  bool read_point(InitialStress& one) {
    std::array<double, 8> values{};  // T, stresses, plastic strain
    const std::size_t first = shells_ ? 0 : 1;
    std::int64_t history = one.history;
    if (one.large == 0) {
      const Card card = reader_.next(shells_ ? keyword::card_layout("INITIAL_STRESS_SHELL", "small")
                                             : keyword::card_layout("INITIAL_STRESS_SOLID", "small"));
      if (!card.present()) return false;
      for (std::size_t i = 0; i + first < values.size(); ++i) values[i + first] = card.real(i);
    } else {
      const Card upper = reader_.next(shells_ ? keyword::card_layout("INITIAL_STRESS_SHELL", "large1")
                                              : keyword::card_layout("INITIAL_STRESS_SOLID", "large1"));
      const Card lower = reader_.next(shells_ ? keyword::card_layout("INITIAL_STRESS_SHELL", "large2")
                                              : keyword::card_layout("INITIAL_STRESS_SOLID", "large2"));
      if (!lower.present()) return false;
      for (std::size_t i = 0; i < 5; ++i) values[i + first] = upper.real(i);
      for (std::size_t i = 0; i + 5 + first < values.size(); ++i) values[i + 5 + first] = lower.real(i);
      // The second card of a solid has room for three history variables.
      for (std::size_t i = 2; !shells_ && i < 5 && history > 0; ++i, --history)
        one.history_used = one.history_used || lower.real(i) != 0;
    }
    if (!skip_history(history, one)) return false;
    StressPoint point;
    point.place = values[0];
    for (std::size_t i = 0; i < 6; ++i) point.stress[i] = values[i + 1] * stress_;
    point.plastic_strain = values[7];
    one.points.push_back(point);
    return true;
  }

  bool skip_history(std::int64_t count, InitialStress& one) {
    static const CardLayout small = real_line(8, small_width), large = real_line(5, large_width);
    const CardLayout& layout = one.large == 0 ? small : large;
    while (count > 0) {
      const Card card = reader_.next(layout);
      if (!card.present()) return false;
      for (std::size_t i = 0; i < card.size() && count > 0; ++i, --count)
        one.history_used = one.history_used || card.real(i) != 0;
    }
    return true;
  }

  CardReader reader_;
  const CardLayout& first_;
  bool shells_, set_;
  double stress_;  ///< factor to the model's unit
  bool turned_;
};

void read_stresses(Context& context, const Block& block, bool shells, bool set) {
  StressReader reader(context, block, shells, set);
  while (!reader.at_end()) {
    if (reader.skip_blank()) continue;
    context.model.initial_stresses.push_back(reader.next());
    // Where the next element begins is known only if this one was read as a whole.
    if (!context.model.initial_stresses.back().complete()) break;
  }
}

/// A point of the block in the model.
Vector point_at(const keyword::Transform& transform, const Card& card, std::size_t field) {
  return transform.apply(Vector(transform.length_factor * vector_at(card, field)));
}

CrossSection read_plane(const Context& context, const Block& block, CardReader& reader) {
  const keyword::Transform& transform = context.transform(block);
  const Card first = reader.next(keyword::card_layout("DATABASE_CROSS_SECTION_PLANE", "card1")),
             second = reader.next(keyword::card_layout("DATABASE_CROSS_SECTION_PLANE", "card2"));
  CrossSection section;
  section.plane = true;
  section.parts = first.integer("psid");
  section.tail = point_at(transform, first, 1);
  section.normal = point_at(transform, first, 4) - section.tail;
  section.radius = first.real("radius") * transform.length_factor;
  section.along = second.real("lenl") * transform.length_factor;
  section.across = second.real("lenm") * transform.length_factor;
  section.system = second.integer("id");
  section.kind_of_system = second.integer("itype");
  if (section.along != 0 || section.across != 0) section.edge = point_at(transform, second, 0) - section.tail;
  section.place = Context::place(block, first.line());
  return section;
}

CrossSection read_sets(const Context& context, const Block& block, CardReader& reader) {
  const Card card = reader.next(keyword::card_layout("DATABASE_CROSS_SECTION_SET", "card1"));
  CrossSection section;
  section.nodes = card.integer("nsid");
  section.solids = card.integer("hsid");
  section.beams = card.integer("bsid");
  section.shells = context.with_offset(block, keyword::IdKind::set, card.integer("ssid"));
  section.others = card.integer("tsid") != 0 ? card.integer("tsid") : card.integer("dsid");
  section.system = card.integer("id");
  section.kind_of_system = card.integer("itype");
  section.place = Context::place(block, card.line());
  return section;
}

}  // namespace

void read_initial_stress_shell(Context& context, const Block& block, const Options& options) {
  read_stresses(context, block, true, options.has("SET"));
}

void read_initial_stress_solid(Context& context, const Block& block, const Options& options) {
  read_stresses(context, block, false, options.has("SET"));
}

void read_cross_section(Context& context, const Block& block, const Options& options) {
  const bool plane = block.name.starts_with("DATABASE_CROSS_SECTION_PLANE");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    std::int64_t id = 0;
    std::string title;
    if (options.has("ID")) {
      const Card named = reader.next(keyword::card_layout("DATABASE_CROSS_SECTION_SET", "ID"));
      id = named.integer("csid");
      title = named.text("heading");
    }
    if (reader.at_end()) break;
    CrossSection section = plane ? read_plane(context, block, reader) : read_sets(context, block, reader);
    section.title = std::move(title);
    section.id = id != 0 ? id : static_cast<std::int64_t>(context.model.cross_sections.size()) + 1;
    context.model.cross_sections.push_back(section);
  }
}

void read_section_preload(Context& context, const Block& block, const Options&) {
  const auto& layout = keyword::card_layout("INITIAL_STRESS_SECTION", "card1");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    SectionPreload preload;
    preload.id = card.integer("issid");
    preload.section = card.integer("csid");
    preload.curve = card.integer("lcid");
    preload.parts = card.integer("psid");
    preload.vector = card.integer("vid");
    preload.shear = card.integer("izshear");
    preload.ghost = card.integer("istiff");
    preload.scale = context.stress(block, 1);
    preload.place = Context::place(block, card.line());
    context.model.section_preloads.push_back(preload);
  }
}

void read_beam_preload(Context& context, const Block& block, const Options&) {
  const auto& layout = keyword::card_layout("INITIAL_AXIAL_FORCE_BEAM", "card1");
  const keyword::Transform& units = context.transform(block);
  const double force = units.mass_factor * units.length_factor / (units.time_factor * units.time_factor);
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    const double scale = card.real("scale");
    context.model.beam_preloads.push_back({card.integer("bsid"), card.integer("lcid"), (scale == 0 ? 1 : scale) * force,
                                           card.integer("kbend"), Context::place(block, card.line())});
  }
}

}  // namespace gapcheck::model
