#include "solver/build/build_welds.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gapcheck::solver {
namespace {

/// A missing exponent is 1.
double power(double written) { return written > 0 ? written : 1; }

LinkStrength strength_of(const model::Weld& weld) {
  LinkStrength strength;
  if (weld.nodes.size() == 2) {
    strength.normal = weld.normal_force;
    strength.shear = weld.shear_force;
    strength.normal_power = power(weld.normal_power);
    strength.shear_power = power(weld.shear_power);
  }
  // In the manual 1e20 means never.
  strength.time = weld.failure_time < 1e20 ? weld.failure_time : 0;
  return strength;
}

}  // namespace

void build_welds(const model::Model& model, Structure& structure, Diagnostics& diagnostics) {
  for (const model::Weld& weld : model.welds) {
    const auto warn = [&](const std::string& message) {
      diagnostics.warning(model.file(weld.place), weld.place.line, fmt::format("weld {}: {}", weld.id, message));
    };
    const auto outside = [&](NodeIndex n) { return n.value >= structure.state.x.size(); };
    if (std::any_of(weld.nodes.begin(), weld.nodes.end(), outside)) continue;
    const auto taken =
        std::find_if(weld.nodes.begin(), weld.nodes.end(), [&](NodeIndex n) { return structure.rigid.holds(n.value); });
    if (taken != weld.nodes.end()) {
      warn(fmt::format("node {} is in another rigid body or weld; the weld takes no part in the calculation",
                       structure.node_id[taken->value]));
      continue;
    }
    if (weld.plastic_strain > 0 && weld.plastic_strain < 1e20) warn("failure by plastic strain is not calculated");
    if (weld.nodes.size() != 2 && (weld.normal_force > 0 || weld.shear_force > 0))
      warn("failure by forces is calculated for two nodes only, here not");
    const std::size_t body = structure.rigid.add({}, weld.nodes, structure.state);
    structure.rigid.set_strength(body, strength_of(weld));
  }
}

}  // namespace gapcheck::solver
