#include "solver/output/plot.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

std::array<double, 3> array_of(const Vector& v) { return {v.x(), v.y(), v.z()}; }

/// Its part and nodes exist.
template <std::size_t N>
bool complete(const model::Elements<N>& elements, std::size_t i, const model::Model& model) {
  return elements.part[i] != none<PartIndex> &&
         std::all_of(elements.nodes[i].begin(), elements.nodes[i].end(),
                     [&](NodeIndex node) { return node.value < model.mesh.nodes.size(); });
}

template <std::size_t N>
void add_elements(const model::Elements<N>& elements, const model::Model& model, results::D3plot::Elements<N>& plot) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!complete(elements, i, model)) continue;
    std::array<std::uint32_t, N> nodes;
    for (std::size_t k = 0; k < N; ++k) nodes[k] = elements.nodes[i][k].value;
    plot.ids.push_back(elements.id[i]);
    plot.nodes.push_back(nodes);
    plot.parts.push_back(model.part(elements.part[i]).id.value);
  }
}

results::StressPoint global_point(const PointState& point, const Matrix& to_global) {
  return {rotated(point.stress, to_global), point.plastic_strain};
}

/// Axial force, shear s t, moments s t, torsion on the second end, by beam of the plot.
void beam_values(const model::Model& model, const Structure& structure, results::D3plotState& plot) {
  const model::Elements<2>& beams = model.mesh.beams;
  std::vector<std::uint32_t> place(beams.size(), no_position);
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < beams.size(); ++i)
    if (complete(beams, i, model)) place[i] = count++;
  plot.beams.assign(count, {});
  for (std::size_t i = 0; i < structure.beams.size(); ++i) {
    if (place[structure.beams.origin(i)] == no_position) continue;
    const Matrix axes = structure.beams.axes(i, structure.state.x);
    const Vector r = axes.col(0), s = axes.col(1), t = axes.col(2);
    const Vector &force = structure.beams.end_force(i), moment = structure.beams.moment_at_end(i, 1);
    plot.beams[place[structure.beams.origin(i)]] = {
        structure.beams.axial(i), force.dot(s), force.dot(t), moment.dot(s), moment.dot(t), moment.dot(r)};
  }
}

/// By layer the mean of the points in the plane.
std::vector<PointState> layer_means(std::span<const PointState> points, std::size_t layers) {
  std::vector<PointState> means(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(layers));
  for (std::size_t i = layers; i < points.size(); ++i) {
    PointState& mean = means[i % layers];
    for (std::size_t k = 0; k < mean.stress.size(); ++k) mean.stress[k] += points[i].stress[k];
    mean.plastic_strain += points[i].plastic_strain;
  }
  const double count = static_cast<double>(points.size() / layers);
  for (PointState& mean : means) {
    for (double& stress : mean.stress) stress /= count;
    mean.plastic_strain /= count;
  }
  return means;
}

/// Failed beams among those of the plot, which are the complete ones.
void delete_beams(const model::Model& model, const std::vector<bool>& failed, std::vector<bool>& deleted) {
  const model::Elements<2>& beams = model.mesh.beams;
  for (std::size_t i = 0; i < beams.size(); ++i)
    if (complete(beams, i, model)) deleted.push_back(i < failed.size() && failed[i]);
}

/// Between the two middle layers if their number is even.
PointState middle(std::span<const PointState> points) {
  PointState mean = points[points.size() / 2];
  if (points.size() % 2 != 0) return mean;
  const PointState& other = points[points.size() / 2 - 1];
  for (std::size_t k = 0; k < mean.stress.size(); ++k) mean.stress[k] = (mean.stress[k] + other.stress[k]) / 2;
  mean.plastic_strain = (mean.plastic_strain + other.plastic_strain) / 2;
  return mean;
}

/// Forces and moments per length in the axes of the element: mxx myy mxy qxz qyz nxx nyy nxy.
std::array<double, 8> resultants(const ShellProperties& properties, std::span<const PointState> points,
                                 double thickness) {
  std::array<double, 8> sum{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double share = thickness / 2 * properties.layers[i].weight;
    const double lever = share * thickness / 2 * properties.layers[i].place;
    const Symmetric& s = points[i].stress;
    const std::array<double, 8> add{lever * s[xx],
                                    lever * s[yy],
                                    lever * s[xy],
                                    share * properties.shear_factor * s[zx],
                                    share * properties.shear_factor * s[yz],
                                    share * s[xx],
                                    share * s[yy],
                                    share * s[xy]};
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += add[k];
  }
  return sum;
}

void shell_values(const Structure& structure, std::size_t shell, results::D3plotState& plot) {
  const ShellElements& shells = structure.shells;
  const std::size_t place = shells.origin(shell);
  const double area = quad_normal(shells.nodes(shell), structure.state.x).norm() / 2,
               thickness = shells.state(shell).thickness;
  const Matrix to_global = shells.axes(shell, structure.state.x);
  const std::vector<PointState> points = layer_means(shells.points(shell), shells.properties(shell).layers.size());
  results::StressPoint* layers = &plot.shell_points[place * plot.layers];
  layers[0] = global_point(middle(points), to_global);
  layers[1] = global_point(points.front(), to_global);
  layers[2] = global_point(points.back(), to_global);
  results::ShellValues& values = plot.shells[place];
  values.resultants = resultants(shells.properties(shell), points, thickness);
  values.thickness = thickness;
  values.internal_energy = shells.energy(shell).internal / (area * thickness);
}

/// Middle, lower and upper layer in global axes.
void thick_shell_values(const model::Model& model, const Structure& structure, results::D3plotState& plot) {
  const ThickShellElements& shells = structure.thick_shells;
  plot.thick_shell_points.resize(results::D3plotState::surfaces * model.mesh.thick_shells.size());
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const Matrix to_global = shells.axes(i, structure.state.x);
    const std::span<const PointState> points = shells.points(i);
    results::StressPoint* layers = &plot.thick_shell_points[results::D3plotState::surfaces * shells.origin(i)];
    layers[0] = global_point(middle(points), to_global);
    layers[1] = global_point(points.front(), to_global);
    layers[2] = global_point(points.back(), to_global);
  }
}

bool failed(const ShellElements& shells, std::size_t i) { return shells.failed(i); }
bool failed(const SolidElements& solids, std::size_t i) { return solids.failed(i); }
bool failed(const BeamElements& beams, std::size_t i) { return beams.failed(i); }
bool failed(const ThickShellElements& shells, std::size_t i) { return shells.failed(i); }

}  // namespace

std::vector<PartEnergy> part_energies(const model::Model& model, const Structure& structure) {
  std::vector<PartEnergy> parts(model.parts.size());
  const auto add = [&](const auto& elements, const std::vector<PartIndex>& part_of) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      PartEnergy& both = parts[part_of[elements.origin(i)].value];
      ElementEnergy& part = failed(elements, i) ? both.eroded : both.present;
      part.internal += elements.energy(i).internal;
      part.viscous += elements.energy(i).viscous;
      part.hourglass += elements.energy(i).hourglass;
    }
  };
  add(structure.shells, model.mesh.shells.part);
  add(structure.solids, model.mesh.solids.part);
  add(structure.beams, model.mesh.beams.part);
  add(structure.thick_shells, model.mesh.thick_shells.part);
  return parts;
}

bool can_fail(const Structure& structure) {
  return structure.shells.can_fail() || structure.solids.can_fail() || structure.beams.can_fail();
}

std::vector<results::LegendEntry> part_titles(const model::Model& model) {
  std::vector<results::LegendEntry> list;
  for (const model::Part& part : model.parts) list.push_back({part.id.value, part.title});
  return list;
}

std::vector<results::LegendEntry> contact_titles(const model::Model& model) {
  std::vector<results::LegendEntry> list;
  for (const model::Contact& contact : model.contacts) list.push_back({contact.id.value, contact.title});
  return list;
}

std::vector<results::LegendEntry> node_titles(const model::Model& model) {
  std::vector<results::LegendEntry> list;
  for (const model::HistoryNode& entry : model.output.history_nodes)
    list.push_back({model.mesh.nodes.id[entry.node.value], entry.title});
  return list;
}

results::D3plot plot_mesh(const model::Model& model, const std::vector<Vector>& x) {
  results::D3plot plot;
  plot.title = model.title;
  plot.node_ids = model.mesh.nodes.id;
  for (const Vector& point : x) plot.coordinates.push_back(array_of(point));
  add_elements(model.mesh.solids, model, plot.solids);
  add_elements(model.mesh.thick_shells, model, plot.thick_shells);
  add_elements(model.mesh.beams, model, plot.beams);
  add_elements(model.mesh.shells, model, plot.shells);
  return plot;
}

results::D3plotState plot_state(const model::Model& model, const Structure& structure,
                                const contact::ElementSizes& sizes, std::span<const PartMotion> motion) {
  results::D3plotState plot;
  const State& state = structure.state;
  plot.time = state.time;
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    plot.coordinates.push_back(array_of(state.x[i]));
    plot.velocities.push_back(array_of(state.v[i]));
  }
  plot.solids.resize(model.mesh.solids.size());
  for (std::size_t i = 0; i < structure.solids.size(); ++i)
    plot.solids[structure.solids.origin(i)] = {structure.solids.point(i).stress,
                                               structure.solids.point(i).plastic_strain};
  thick_shell_values(model, structure, plot);
  plot.shell_points.resize(plot.layers * model.mesh.shells.size());
  plot.shells.resize(model.mesh.shells.size());
  for (std::size_t i = 0; i < plot.shells.size(); ++i) plot.shells[i].thickness = sizes.shell_thickness[i];
  parallel_for(structure.shells.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) shell_values(structure, i, plot);
  });
  if (state.failed.count > 0) {
    plot.deleted_solids = state.failed.solids;
    plot.deleted_solids.resize(plot.solids.size(), false);
    plot.deleted_shells = state.failed.shells;
    plot.deleted_shells.resize(plot.shells.size(), false);
    delete_beams(model, state.failed.beams, plot.deleted_beams);
  }
  beam_values(model, structure, plot);
  const std::vector<PartEnergy> energies = part_energies(model, structure);
  double mass = 0;
  Vector momentum = Vector::Zero();
  for (std::size_t part = 0; part < model.parts.size(); ++part) {
    const PartMotion& m = motion[part];
    const ElementEnergy& energy = energies[part].present;
    results::PartValues values{energy.printed_internal(), m.kinetic, m.mass, energy.hourglass, {}};
    if (m.mass > 0) values.velocity = array_of(m.momentum / m.mass);
    plot.parts.push_back(values);
    mass += m.mass;
    momentum += m.momentum;
  }
  if (mass > 0) plot.velocity = array_of(momentum / mass);
  return plot;
}

}  // namespace gapcheck::solver
