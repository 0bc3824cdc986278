#include "solver/build/build_springs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "solver/build/build_spring_law.hpp"

namespace gapcheck::solver {
namespace {

/// Collects springs; remembers the first failure.
class Collector {
 public:
  Collector(const model::Model& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  void add(std::uint32_t element) {
    const model::Elements<2>& discrete = model_.mesh.discrete;
    const std::int64_t id = discrete.id[element];
    const PartIndex part = discrete.part[element];
    const model::Place place{discrete.origins.file(element), discrete.line[element]};
    if (part == none<PartIndex> || !model_.part(part).section || !model_.part(part).material)
      return fail(Failure::Kind::missing_material,
                  fmt::format("discrete element {} has no part, section or material; define them or leave it out", id),
                  place);
    const model::Section& section = model_.sections[*model_.part(part).section];
    if (section.kind != model::SectionKind::discrete)
      return fail(Failure::Kind::missing_material,
                  fmt::format("discrete element {} is in part {}, whose section {} is for other elements", id,
                              model_.part(part).id.value, section.id),
                  place);
    const auto& values = model_.mesh.discrete_values;
    const model::DiscreteValues own = element < values.size() ? values[element] : model::DiscreteValues{};
    const auto& [a, b] = discrete.nodes[element];
    if (const std::string_view why = left_out(section, own, a, b); !why.empty()) {
      diagnostics_.warning(model_.file(place), place.line,
                           fmt::format("discrete element {} {}; it takes no part in the calculation", id, why));
      return;
    }
    if (const auto law = law_of(part, section)) {
      check_line(*law, b != none<NodeIndex> && model_.mesh.nodes.x[a.value] != model_.mesh.nodes.x[b.value], id, place);
      springs.push_back({a, b, *law, own.scale, own.offset, section.torsional, element});
    }
  }

  std::vector<SpringLaw> laws;
  std::vector<SpringInput> springs;
  SolverStatus status;

 private:
  void fail(Failure::Kind kind, std::string message, model::Place place) {
    if (status.ok()) status = Failure{kind, std::move(message), place};
  }

  [[nodiscard]] std::string_view left_out(const model::Section& section, const model::DiscreteValues& own, NodeIndex a,
                                          NodeIndex b) const {
    const std::size_t nodes = model_.mesh.nodes.size();
    if (a.value >= nodes || (b != none<NodeIndex> && b.value >= nodes)) return "has a node that is not there";
    if (own.orientation != 0) return "acts along a vector (VID), which is not calculated";
    const bool apart = b != none<NodeIndex> && model_.mesh.nodes.x[a.value] != model_.mesh.nodes.x[b.value];
    if (section.torsional && !apart) return "has no axis to turn about";
    return {};
  }

  std::optional<std::uint32_t> law_of(PartIndex part, const model::Section& section) {
    const auto [entry, is_new] = law_of_part_.try_emplace(part.value, static_cast<std::uint32_t>(laws.size()));
    if (!is_new) return entry->second;
    const model::Material& material = model_.materials[*model_.part(part).material];
    if (section.limited && material.discrete)
      diagnostics_.warning(model_.file(section.place), section.place.line,
                           fmt::format("section {}: KD, V0, CL, FD, CDL and TDL are not calculated", section.id));
    SolverResult<SpringLaw> law = build_spring_law(model_, material, section.torsional, diagnostics_);
    if (!law) {
      if (status.ok()) status = law.error();
      return std::nullopt;
    }
    laws.push_back(std::move(law).value());
    return entry->second;
  }

  /// Springs whose law asks for a line but which have none.
  void check_line(std::uint32_t law, bool line, std::int64_t id, model::Place place) {
    if (line || laws[law].kind == SpringLaw::Kind::elastic || laws[law].kind == SpringLaw::Kind::elastoplastic) return;
    if (laws[law].kind == SpringLaw::Kind::inelastic)
      fail(Failure::Kind::contradiction,
           fmt::format("discrete element {} has no length at the start, so its material (*MAT_SPRING_INELASTIC) cannot "
                       "tell tension from compression; place its nodes apart",
                       id),
           place);
    else if (std::isfinite(laws[law].cutoff))
      fail(Failure::Kind::contradiction,
           fmt::format("discrete element {} has no length at the start, so that the force FC of its material "
                       "(*MAT_SPRING_MAXWELL) has no direction; place its nodes apart or set TC to 0",
                       id),
           place);
  }

  const model::Model& model_;
  Diagnostics& diagnostics_;
  std::map<std::uint32_t, std::uint32_t> law_of_part_;
};

}  // namespace

SolverResult<std::unique_ptr<Springs>> build_springs(const model::Model& model, const Structure& structure,
                                                     Diagnostics& diagnostics) {
  Collector collector(model, diagnostics);
  for (std::uint32_t i = 0; i < model.mesh.discrete.size() && collector.status.ok(); ++i) collector.add(i);
  if (!collector.status.ok()) return collector.status.error();
  if (collector.springs.empty()) return std::unique_ptr<Springs>();
  return std::make_unique<Springs>(std::move(collector.laws), std::move(collector.springs), structure.state,
                                   structure.rigid);
}

}  // namespace gapcheck::solver
