#include "solver/build/build_springs.hpp"

#include <fmt/format.h>

#include <map>

namespace gapcheck::solver {
namespace {

using SpringKind = model::DiscreteMaterial::Kind;

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
    if (const auto law = law_of(part, section))
      springs.push_back({a, b, *law, own.scale, own.offset, section.torsional, element});
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
    const auto warn = [&](model::Place place, const std::string& message) {
      diagnostics_.warning(model_.file(place), place.line, message);
    };
    if (!material.discrete) {
      fail(Failure::Kind::bad_material,
           fmt::format("material {} (*{}) is none of the springs and dampers S01, S02 and S04; replace it for this run",
                       material.id, material.keyword),
           material.place);
      return std::nullopt;
    }
    const model::DiscreteMaterial& data = *material.discrete;
    if (section.limited)
      warn(section.place, fmt::format("section {}: KD, V0, CL, FD, CDL and TDL are not calculated", section.id));
    if (data.rate_curve != 0)
      warn(material.place, fmt::format("material {}: the curve over the rate (LCR) is not calculated", material.id));
    SpringLaw law;
    const double constant = data.constant * (section.torsional ? data.length_factor * data.length_factor : 1);
    (data.kind == SpringKind::damper ? law.damping : law.stiffness) = constant;
    if (data.kind == SpringKind::nonlinear_spring) law.curve = curve_of(material);
    laws.push_back(std::move(law));
    return entry->second;
  }

  /// The points with strictly rising elongations.
  std::vector<std::array<double, 2>> curve_of(const model::Material& material) {
    std::vector<std::array<double, 2>> points;
    const auto curve = model_.curves.find(material.discrete->curve);
    if (curve != model_.curves.end())
      for (const auto& point : curve->second.points)
        if (points.empty() || point[0] > points.back()[0]) points.push_back(point);
    if (points.size() < 2)
      fail(Failure::Kind::bad_material,
           fmt::format("material {} (*{}): curve {} is not there or has no two points", material.id, material.keyword,
                       material.discrete->curve),
           material.place);
    return points;
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
