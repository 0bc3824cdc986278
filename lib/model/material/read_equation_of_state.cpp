#include <fmt/format.h>

#include <algorithm>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

using StateKind = EquationOfState::Kind;

StateKind state_kind(std::string_view name) {
  if (name.ends_with("_TITLE")) name.remove_suffix(6);
  if (name == "EOS_LINEAR_POLYNOMIAL" || name == "EOS_001" || name == "EOS_1") return StateKind::linear_polynomial;
  if (name == "EOS_GRUNEISEN" || name == "EOS_004" || name == "EOS_4") return StateKind::gruneisen;
  if (name == "EOS_TABULATED" || name == "EOS_009" || name == "EOS_9") return StateKind::tabulated;
  return StateKind::other;
}

void read_polynomial(CardReader& reader, double stress, EquationOfState& state) {
  const Card first = reader.next(keyword::card_layout("EOS_LINEAR_POLYNOMIAL", "card1"));
  for (std::size_t i = 0; i < state.polynomial.size(); ++i)
    state.polynomial[i] = first.real(i + 1) * (i < 4 ? stress : 1);
  const Card second = reader.next(keyword::card_layout("EOS_LINEAR_POLYNOMIAL", "card2"));
  state.e0 = second.real("e0") * stress;
  state.v0 = second.real("v0");
}

void read_gruneisen(CardReader& reader, double stress, double velocity, EquationOfState& state) {
  const Card first = reader.next(keyword::card_layout("EOS_GRUNEISEN", "card1"));
  state.c = first.real("c") * velocity;
  state.s1 = first.real("s1");
  state.s2 = first.real("s2");
  state.s3 = first.real("s3");
  state.gamma = first.real("gamao");
  state.a = first.real("a");
  state.e0 = first.real("e0") * stress;
  const Card second = reader.next(keyword::card_layout("EOS_GRUNEISEN", "card2"));
  state.v0 = second.real("v0");
  state.by_curves = second.real("lcid") != 0;
}

void read_table_of_pressure(CardReader& reader, double stress, EquationOfState& state) {
  constexpr std::size_t rows = 10, per_card = 5;
  const Card first = reader.next(keyword::card_layout("EOS_TABULATED", "card1"));
  state.gamma = first.real("gama");
  state.e0 = first.real("e0") * stress;
  state.v0 = first.real("v0");
  state.by_curves = first.integer("lcc") != 0 || first.integer("lct") != 0;
  state.rows.assign(rows, {});
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < rows; row += per_card) {
      const Card card = reader.next(keyword::card_layout("EOS_TABULATED", "card2"));
      for (std::size_t i = 0; i < per_card; ++i)
        state.rows[row + i][column] = card.real(i) * (column == 1 ? stress : 1);
    }
  const auto blank = [](const std::array<double, 3>& row) { return row == std::array<double, 3>{}; };
  // A last row of zeros may be the state at rest.
  while (state.rows.size() > 1 && blank(state.rows.back()) && blank(state.rows[state.rows.size() - 2]))
    state.rows.pop_back();
  const bool falls = state.rows.size() > 2 && state.rows[0][0] > state.rows[1][0];
  if (state.rows.size() > 1 && blank(state.rows.back()) && (state.rows[state.rows.size() - 2][0] < 0) == falls)
    state.rows.pop_back();
}

}  // namespace

void read_equation_of_state(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  const Place start = Context::place(block, block.line);
  if (reader.at_end()) {
    context.warning(start, fmt::format("*{} has no card; it is left out", block.name));
    return;
  }
  EquationOfState state;
  state.kind = state_kind(block.name);
  state.keyword = block.name;
  state.place = Context::place(block, reader.peek_line());
  state.id = reader.peek(keyword::card_layout("EOS_LINEAR_POLYNOMIAL", "card1")).integer(std::size_t{0});
  const keyword::Transform& units = context.transform(block);
  const double stress = context.stress(block, 1);
  if (state.kind == StateKind::linear_polynomial) read_polynomial(reader, stress, state);
  if (state.kind == StateKind::gruneisen)
    read_gruneisen(reader, stress, units.length_factor / units.time_factor, state);
  if (state.kind == StateKind::tabulated) read_table_of_pressure(reader, stress, state);
  const Place again = state.place;
  const std::int64_t id = state.id;
  const auto [entry, is_new] = context.model.equations_of_state.try_emplace(id, std::move(state));
  if (!is_new) context.duplicate("equation of state", id, entry->second.place, again);
}

void finish_equations_of_state(Context& context) {
  Model& model = context.model;
  for (const Part& part : model.parts) {
    const auto found = model.equations_of_state.find(part.eos_id);
    if (part.eos_id == 0 || !part.material || found == model.equations_of_state.end()) continue;
    Material& material = model.materials[*part.material];
    const double shear = material.hydro          ? material.hydro->shear
                         : material.johnson_cook ? material.johnson_cook->shear
                                                 : 0;
    if ((!material.fluid && !material.hydro && !material.johnson_cook) || material.bulk != 0) continue;
    const double bulk = initial_bulk_modulus(found->second, material.density);
    if (!(bulk > 0)) continue;
    material.bulk = bulk;
    material.stiffness_known = true;
    if (!(shear > 0)) continue;
    material.young = 9 * bulk * shear / (3 * bulk + shear);
    material.poisson = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
  }
}

}  // namespace gapcheck::model
