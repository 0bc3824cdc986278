#include "solver/build/build_shell_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/build/build.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::int64_t most_rule_points = 1000;

double mean_over_layers(const ShellProperties& properties, double (*value)(const Material&)) {
  double sum = 0;
  for (std::size_t i = 0; i < properties.layers.size(); ++i)
    sum += properties.layers[i].weight / 2 * value(properties.layer_materials[i]);
  return sum;
}

SolverResult<Material> layer_material(const model::Model& model, std::uint32_t position, const LayeredBy& owner) {
  auto material = build_material(model, model.materials[position]);
  if (!material) return material.error();
  const MaterialKind kind = material.value().kind;
  const bool known = kind == MaterialKind::elastic || kind == MaterialKind::plastic || kind == MaterialKind::null;
  if (!known || material.value().erosion || material.value().johnson_cook)
    return Failure{Failure::Kind::bad_material,
                   fmt::format("material {} is not calculated in plies of composites, but {} has one of it",
                               model.materials[position].id, owner.name),
                   owner.place};
  return material;
}

/// What mass, time step and hourglass control take.
void set_mean_material(ShellProperties& properties) {
  Material& mean = properties.material;
  mean = properties.layer_materials.front();
  mean.density = mean_over_layers(properties, [](const Material& m) { return m.density; });
  mean.poisson = mean_over_layers(properties, [](const Material& m) { return m.poisson; });
  const double modulus = mean_over_layers(properties, [](const Material& m) { return m.plate_modulus(); });
  mean.young = modulus * (1 - mean.poisson * mean.poisson);
  double largest = modulus;
  for (const Material& material : properties.layer_materials) {
    largest =
        std::max(largest, material.plate_modulus() * (1 + std::abs(material.poisson)) / (1 + std::abs(mean.poisson)));
    largest = std::max(largest, modulus * material.shear() / mean.shear());
    if (material.failure_strain > 0) mean.failure_strain = material.failure_strain;
  }
  properties.stiffest = modulus > 0 ? largest / modulus : 1;
}

/// A rule with its section, for messages.
struct NamedRule {
  std::int64_t id;
  const model::ShellRule& rule;
  [[nodiscard]] Failure fault(Failure::Kind kind, const std::string& why) const {
    return Failure{kind, fmt::format("*INTEGRATION_SHELL: rule {} {}", id, why), rule.place};
  }
};

SolverStatus check_rule(const NamedRule& named, const model::Section& section) {
  const model::ShellRule& rule = named.rule;
  const auto contradiction = [&](const std::string& why) { return named.fault(Failure::Kind::contradiction, why); };
  if (rule.count < 1 || rule.count > most_rule_points)
    return contradiction(fmt::format("has NIP = {}; give it 1 to {} points", rule.count, most_rule_points));
  if (rule.equal != 0 && rule.equal != 1) return contradiction(fmt::format("has ESOP = {}; set 0 or 1", rule.equal));
  if (rule.failure != 0 && rule.failure != 1)
    return contradiction(fmt::format("has FAILOPT = {}; set 0 or 1", rule.failure));
  if (section.elform == 5 || section.elform == 9)
    return named.fault(
        Failure::Kind::not_calculated,
        fmt::format("is that of membranes (section {}, ELFORM {}), which have one point; set QR/IRID to 0", section.id,
                    section.elform));
  if (rule.equal == 1) return {};
  if (static_cast<std::int64_t>(rule.points.size()) != rule.count)
    return contradiction(fmt::format("lists {} of its {} points", rule.points.size(), rule.count));
  double sum = 0;
  for (const model::ShellRule::Point& point : rule.points) {
    if (!(std::abs(point.place) <= 1) || !(point.weight > 0))
      return contradiction(
          fmt::format("has a point with S = {:g} and WF = {:g}; S lies between -1 and 1, and WF is "
                      "above 0",
                      point.place, point.weight));
    sum += point.weight;
  }
  constexpr double written_digits = 1e-3;
  if (!(std::abs(sum - 1) < written_digits))
    return contradiction(
        fmt::format("has weights WF whose sum is {:g}; they are shares of the thickness, whose sum is 1", sum));
  return {};
}

/// The material of a point: that of another part of the same material type.
SolverResult<std::uint32_t> material_at(const model::Model& model, const model::Part& part, const NamedRule& named,
                                        std::int64_t id) {
  if (id == 0) return *part.material;
  const auto other = model.part_of_id.find(id);
  if (other == model.part_of_id.end() || !model.part(other->second).material)
    return named.fault(Failure::Kind::unknown_reference,
                       fmt::format("has a point of part {}, which is not defined or has no material", id));
  const std::uint32_t position = *model.part(other->second).material;
  const std::string &own = model.materials[*part.material].keyword, &there = model.materials[position].keyword;
  if (own != there)
    return named.fault(
        Failure::Kind::not_calculated,
        fmt::format("has a point of *{} in a shell of *{}; the material type must not change", there, own));
  return position;
}

/// Layers that fail beside others that cannot: FAILOPT = 0 deletes the element with the first ones.
SolverStatus check_mixed_failure(const NamedRule& named, const ShellProperties& properties) {
  const auto fails = [](const Material& material) { return material.failure_strain > 0; };
  const auto& all = properties.layer_materials;
  const auto failing = std::count_if(all.begin(), all.end(), fails);
  if (named.rule.failure == 1 || failing == 0 || failing == static_cast<std::ptrdiff_t>(all.size())) return {};
  return named.fault(
      Failure::Kind::not_calculated,
      "mixes materials that fail with others that do not; set FAILOPT to 1, with which the element stays");
}

}  // namespace

SolverStatus set_plies(const model::Model& model, const std::vector<model::Ply>& plies, double thickness,
                       const LayeredBy& owner, ShellProperties& properties) {
  properties.layers.clear();
  double below = 0;
  for (const model::Ply& ply : plies) {
    const double share = ply.thickness / thickness;
    if (!(share > 0) || !ply.material)
      return Failure{Failure::Kind::missing_material,
                     fmt::format("{} has a ply of material {} with thickness {:g}; give it a material that is "
                                 "defined and a thickness above zero",
                                 owner.name, ply.material_id, ply.thickness),
                     owner.place};
    auto material = layer_material(model, *ply.material, owner);
    if (!material) return material.error();
    properties.layers.push_back({2 * (below + share / 2) - 1, 2 * share});
    properties.layer_materials.push_back(std::move(material).value());
    below += share;
  }
  set_mean_material(properties);
  return {};
}

SolverStatus set_rule(const model::Model& model, const model::Part& part, const model::Section& section,
                      ShellProperties& properties) {
  const auto found = model.shell_rules.find(-section.rule);
  if (found == model.shell_rules.end())
    return Failure{Failure::Kind::unknown_reference,
                   fmt::format("*SECTION_SHELL: section {} names the rule {}, which is not defined by an "
                               "*INTEGRATION_SHELL; define it or set QR/IRID to 0",
                               section.id, -section.rule),
                   section.place};
  const NamedRule named{found->first, found->second};
  if (SolverStatus checked = check_rule(named, section); !checked.ok()) return checked;
  const model::ShellRule& rule = named.rule;
  properties.layers.clear();
  const auto count = static_cast<double>(rule.count);
  for (std::int64_t i = 0; rule.equal == 1 && i < rule.count; ++i)
    properties.layers.push_back({(2 * static_cast<double>(i) + 1) / count - 1, 2 / count});
  bool own = false;
  for (const model::ShellRule::Point& point : rule.points) {
    properties.layers.push_back({point.place, 2 * point.weight});
    own = own || point.part_id != 0;
  }
  if (!own) return {};
  const LayeredBy owner{fmt::format("part {}", part.id.value), rule.place};
  for (const model::ShellRule::Point& point : rule.points) {
    const auto position = material_at(model, part, named, point.part_id);
    if (!position) return position.error();
    auto material = layer_material(model, position.value(), owner);
    if (!material) return material.error();
    properties.layer_materials.push_back(std::move(material).value());
  }
  set_mean_material(properties);
  return check_mixed_failure(named, properties);
}

}  // namespace gapcheck::solver
