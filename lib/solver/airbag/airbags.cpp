#include "solver/airbag/airbags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gapcheck::solver {
namespace {

/// Σ |force|² / mass over nodes and, with their torques, over rigid bodies: the squared frequency of a unit stiffness
/// against the volume.
double yielding(const std::vector<std::uint32_t>& nodes, const std::vector<Vector>& forces, const State& state) {
  struct Load {
    Vector force = Vector::Zero(), torque = Vector::Zero();
  };
  std::map<std::uint32_t, Load> bodies;
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint32_t node = nodes[i];
    if (state.in_body(node)) {
      Load& load = bodies[state.body[node]];
      load.force += forces[i];
      load.torque += (state.x[node] - state.bodies[state.body[node]].center).cross(forces[i]);
    } else if (state.mass[node] > 0) {
      sum += forces[i].squaredNorm() / state.mass[node];
    }
  }
  for (const auto& [position, load] : bodies) {
    const BodyState& body = state.bodies[position];
    sum += load.force.squaredNorm() / body.mass;
    const Vector turn = body.inertia.ldlt().solve(load.torque);
    if (turn.allFinite()) sum += std::max(load.torque.dot(turn), 0.0);
  }
  return sum;
}

}  // namespace

double PressureByVolume::pressure(double relative, double time) const {
  if (!over_volume.curve.points.empty()) return over_volume.at(relative);
  return coefficient * (coefficients != nullptr ? coefficients->at(time) : 1) / relative;
}

double PressureByVolume::stiffness(double relative, double time) const {
  if (over_volume.curve.points.empty()) return std::abs(pressure(relative, time)) / relative;
  const auto& points = over_volume.curve.points;
  double steepest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i][0] > points[i - 1][0])
      steepest = std::max(steepest, std::abs((points[i][1] - points[i - 1][1]) / (points[i][0] - points[i - 1][0])));
  return steepest * over_volume.unit;
}

Airbags::Airbags(std::vector<AirbagInput> airbags, const State& state) {
  for (AirbagInput& input : airbags) {
    Bag bag{std::move(input), 0, 0, {}};
    bag.start = bag.before = bag.input.volume_scale * bag.input.surface.volume(state.x) - bag.input.excluded;
    if (bag.input.gas) bag.content = GasContent::start(*bag.input.gas, bag.start);
    bags_.push_back(std::move(bag));
  }
  states_.resize(bags_.size());
}

double Airbags::advance(Bag& bag, double volume, const State& state, AirbagState& now) const {
  const double scales = bag.input.pressure_scale * bag.input.volume_scale;
  if (!bag.input.gas) {
    const double relative = volume / bag.start;
    now.pressure = bag.input.law.pressure(relative, state.time);
    return scales * bag.input.law.stiffness(relative, state.time) / bag.start;
  }
  const AirbagGas& gas = *bag.input.gas;
  GasContent& content = bag.content;
  content.advance(gas, bag.before, volume, state.time, state.dt);
  now.pressure = gas.pressure(content.energy, volume);
  now.energy = content.energy;
  now.mass = content.mass;
  now.density = content.mass / volume;
  now.temperature = content.mass > 0 ? content.energy / (content.mass * gas.heat_volume) : 0;
  now.rate_in = content.rate_in;
  now.rate_out = content.rate_out;
  return scales * gas.ratio() * now.pressure / volume;
}

void Airbags::add(State& state, Forces& forces) {
  double squared_frequency = 0;
  for (std::size_t i = 0; i < bags_.size(); ++i) {
    Bag& bag = bags_[i];
    AirbagState& now = states_[i];
    now.airbag = bag.input.airbag;
    now.area = bag.input.surface.area(state.x);
    now.volume = bag.input.volume_scale * bag.input.surface.volume(state.x) - bag.input.excluded;
    if (!(now.volume > 0)) {
      status_ = Failure{Failure::Kind::bad_element,
                        fmt::format("the volume of airbag {} of the deck has fallen to {:g} at time {:g}; look at what "
                                    "presses its sides through one another",
                                    bag.input.airbag + 1, now.volume, state.time)};
      return;
    }
    const double stiffness = advance(bag, now.volume, state, now);
    bag.before = now.volume;
    const double ambient = bag.input.gas ? bag.input.gas->ambient_pressure : 0;
    const double applied = bag.input.pressure_scale * (now.pressure - ambient);
    const std::vector<std::uint32_t>& nodes = bag.input.surface.nodes();
    const std::vector<Vector> unit = bag.input.surface.forces(state.x);
    for (std::size_t k = 0; k < nodes.size(); ++k) forces.force[nodes[k]] += applied * unit[k];
    squared_frequency += stiffness * yielding(nodes, unit, state);
  }
  // It only falls: a step that rises and falls with a vibration feeds it.
  if (squared_frequency > 0) step_ = std::min(step_, step_beside(state, {squared_frequency, 0}));
}

}  // namespace gapcheck::solver
