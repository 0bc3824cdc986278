#include "results/curves/binout_write_histories.hpp"

#include "results/curves/binout_columns.hpp"

namespace gapcheck::results {
namespace {

/// A number of each row, by a function.
template <class Row, class Value>
std::vector<double> reals_of(std::span<const Row> rows, const Value& value) {
  std::vector<double> list;
  for (const Row& row : rows) list.push_back(value(row));
  return list;
}
template <class Row, class Value>
std::vector<std::int64_t> integers_of(std::span<const Row> rows, const Value& value) {
  std::vector<std::int64_t> list;
  for (const Row& row : rows) list.push_back(static_cast<std::int64_t>(value(row)));
  return list;
}

template <class Row>
void write_ids(LsdaWriter& file, std::span<const Row> rows, std::int64_t Row::*id, std::string_view name = "ids") {
  file.integers(name, integers_of(rows, [&](const Row& row) { return row.*id; }));
}

/// The forces of one kind on nodes, or on bodies.
void add_boundary_branch(BinoutWriter& binout, double time, BoundaryKind kind, bool body,
                         std::span<const BoundaryState> rows) {
  LsdaWriter& file = binout.file();
  const std::string branch = boundary_branch(kind, body);
  if (binout.begin_metadata(branch)) {
    write_ids(file, rows, &BoundaryState::id);
    if (kind == BoundaryKind::velocity && !body) file.integers("setid", std::vector<std::int64_t>(rows.size()));
  }
  binout.begin_state(branch, time);
  write_columns(file, boundary_columns(kind == BoundaryKind::velocity && body), rows);
  Vector total = Vector::Zero();
  double energy = 0;
  for (const BoundaryState& row : rows) {
    total += row.force;
    energy += row.energy;
  }
  for (const int axis : {0, 1, 2}) file.real(axis_name("?_total", axis), total[axis]);
  file.real("etotal", energy);
}

using Elements = std::span<const ElementStress>;

/// The points of all elements one after the other, in the order of the arrays: by layer, then by point in the plane.
std::vector<const StressRow*> points_in_order(Elements elements) {
  std::vector<const StressRow*> list;
  for (const ElementStress& e : elements) {
    const std::size_t layers = e.kind == StressKind::shell ? e.layers : e.points.size();
    for (std::size_t layer = 0; layer < layers; ++layer)
      for (std::size_t i = layer; i < e.points.size(); i += layers) list.push_back(&e.points[i]);
  }
  return list;
}

void write_points(LsdaWriter& file, StressKind kind, const std::vector<const StressRow*>& points) {
  const auto reals = [&](std::string_view name, const auto& value) {
    std::vector<double> list;
    for (const StressRow* point : points) list.push_back(value(*point));
    file.reals(name, list);
  };
  const auto plastic_strain = [](const StressRow& point) { return point.plastic_strain; };
  if (kind == StressKind::beam) {
    if (points.empty()) return;
    for (const auto& [name, k] : {std::pair("sigma_11", 0u), {"sigma_12", 3u}, {"sigma_31", 5u}})
      reals(name, [k = k](const StressRow& point) { return point.stress[k]; });
    return reals("plastic_eps", plastic_strain);
  }
  std::vector<std::int64_t> states;
  for (const StressRow* point : points) states.push_back(point->plastic ? 2 : 1);
  file.integers("state", states);
  constexpr std::array<std::string_view, 6> names{"sig_xx", "sig_yy", "sig_zz", "sig_xy", "sig_yz", "sig_zx"};
  for (std::size_t k = 0; k < names.size(); ++k)
    reals(names[k], [k](const StressRow& point) { return point.stress[k]; });
  reals(kind == StressKind::solid ? "yield" : "plastic_strain", plastic_strain);
  if (kind == StressKind::solid) reals("effsg", [](const StressRow& point) { return point.effective; });
}

void write_elements(LsdaWriter& file, StressKind kind, Elements elements) {
  const auto in_plane = [](const ElementStress& e) { return e.points.size() / e.layers; };
  const auto integers = [&](std::string_view name, const auto& value) {
    file.integers(name, integers_of(elements, value));
  };
  write_ids(file, elements, &ElementStress::id);
  integers(kind == StressKind::solid ? "mtype" : "mat", [](const ElementStress& e) { return e.part; });
  if (kind == StressKind::beam) {
    integers("nip", [](const ElementStress& e) { return e.points.size(); });
    constexpr std::array<std::string_view, 6> names{"axial", "shear_s", "shear_t", "moment_s", "moment_t", "torsion"};
    for (std::size_t k = 0; k < names.size(); ++k)
      file.reals(names[k], reals_of(elements, [k](const ElementStress& e) { return e.resultants[k]; }));
  }
  if (kind == StressKind::shell) {
    integers("nip", [](const ElementStress& e) { return e.layers; });
    integers("iop", [](const ElementStress&) { return 1; });
    bool several = false;
    for (const ElementStress& e : elements) several = several || in_plane(e) > 1;
    if (several) integers("npl", in_plane);
  }
  write_points(file, kind, points_in_order(elements));
}

}  // namespace

void add_secforc(BinoutWriter& binout, const std::vector<LegendEntry>& titles, double time,
                 std::span<const SectionState> sections) {
  if (sections.empty()) return;  // none is calculated
  LsdaWriter& file = binout.file();
  if (binout.begin_metadata("secforc")) {
    write_ids(file, sections, &SectionState::section);
    // What a section's forces follow: nothing.
    for (const char* name : {"rigidbody", "accelerometer", "coordinate_system"})
      file.integers(name, std::vector<std::int64_t>(sections.size()));
    binout.legend(titles);
  }
  binout.begin_state("secforc", time);
  write_columns(file, section_columns(), sections);
  file.reals("total_force", reals_of(sections, [](const SectionState& s) { return s.force.stableNorm(); }));
  file.reals("total_moment", reals_of(sections, [](const SectionState& s) { return s.moment.stableNorm(); }));
}

void add_spcforc(BinoutWriter& binout, double time, const SupportStates& states) {
  std::vector<SupportState> forces, moments;
  for (const SupportState& s : states.supports) {
    if (s.translation) forces.push_back(s);
    if (s.rotation) moments.push_back(s);
  }
  LsdaWriter& file = binout.file();
  if (binout.begin_metadata("spcforc")) {
    if (!forces.empty()) write_ids<SupportState>(file, forces, &SupportState::node, "force_ids");
    if (!moments.empty()) write_ids<SupportState>(file, moments, &SupportState::node, "moment_ids");
  }
  binout.begin_state("spcforc", time);
  if (!forces.empty()) write_columns<SupportState>(file, support_force_columns(), forces);
  if (!moments.empty()) write_columns<SupportState>(file, support_moment_columns(), moments);
  for (const int axis : {0, 1, 2}) file.real(axis_name("?_resultant", axis), states.resultant[axis]);
}

void add_bndout(BinoutWriter& binout, double time, std::span<const BoundaryState> states) {
  for (const BoundaryKind kind : {BoundaryKind::discrete, BoundaryKind::pressure, BoundaryKind::velocity})
    for (const bool body : {false, true}) {
      std::vector<BoundaryState> rows;
      for (const BoundaryState& state : states)
        if (state.kind == kind && state.body == body) rows.push_back(state);
      if (!rows.empty()) add_boundary_branch(binout, time, kind, body, rows);
    }
}

void add_rwforc(BinoutWriter& binout, const std::vector<LegendEntry>& titles, double time,
                std::span<const WallForce> walls) {
  if (binout.begin_metadata("rwforc/forces")) {
    write_ids(binout.file(), walls, &WallForce::wall);
    write_ids(binout.file(), walls, &WallForce::wall, "setid");
    binout.legend(titles);
  }
  binout.begin_state("rwforc/forces", time);
  write_columns(binout.file(), wall_columns(), walls);
}

void add_rbdout(BinoutWriter& binout, std::uint64_t cycle, double time, std::span<const BodyMotion> bodies) {
  binout.begin_state("rbdout", time);
  LsdaWriter& file = binout.file();
  file.integer("cycle", static_cast<std::int64_t>(cycle));
  write_ids(file, bodies, &BodyMotion::body);
  std::int64_t nodal = 0;
  for (const BodyMotion& b : bodies) nodal += b.nodal ? 1 : 0;
  file.integer("num_nodal", nodal);
  write_columns(file, body_columns(), bodies);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      file.reals(axis_array(r + 1, c + 1), reals_of(bodies, [&](const BodyMotion& b) { return b.axes(r, c); }));
  for (const auto& [pattern, member] : {std::pair("local_d?", &BodyMotion::displacement),
                                        {"local_rd?", &BodyMotion::rotation},
                                        {"local_v?", &BodyMotion::velocity},
                                        {"local_rv?", &BodyMotion::spin},
                                        {"local_a?", &BodyMotion::acceleration},
                                        {"local_ra?", &BodyMotion::spin_rate}})
    for (const int axis : {0, 1, 2})
      file.reals(axis_name(pattern, axis), reals_of(bodies, [member = member, axis](const BodyMotion& b) {
                   return b.axes.col(axis).dot(b.*member);
                 }));
}

void add_swforc(BinoutWriter& binout, double time, std::span<const WeldForce> welds) {
  LsdaWriter& file = binout.file();
  if (binout.begin_metadata("swforc")) {
    write_ids(file, welds, &WeldForce::id);
    file.integers("types", integers_of(welds, [](const WeldForce& w) { return w.kind; }));
  }
  binout.begin_state("swforc", time);
  write_columns(file, weld_columns(), welds);
  file.reals("failure", reals_of(welds, [](const WeldForce& w) { return w.failed ? 1.0 : 0.0; }));
}

void add_elout(BinoutWriter& binout, const std::array<std::vector<LegendEntry>, 3>& titles, std::uint64_t cycle,
               double time, bool local, std::span<const ElementStress> elements) {
  LsdaWriter& file = binout.file();
  for (const StressKind kind : {StressKind::solid, StressKind::beam, StressKind::shell}) {
    std::vector<ElementStress> chosen;
    for (const ElementStress& element : elements)
      if (element.kind == kind) chosen.push_back(element);
    const std::string branch = element_branch(kind);
    if (chosen.empty() && !binout.has(branch)) continue;
    if (binout.begin_metadata(branch)) {
      if (kind != StressKind::beam) file.text("states", "elastic,plastic");
      if (kind == StressKind::shell) file.text("system", local ? "local " : "global");
      binout.legend(titles[static_cast<std::size_t>(kind)]);
    }
    binout.begin_state(branch, time);
    file.integer("cycle", static_cast<std::int64_t>(cycle));
    if (!chosen.empty()) write_elements(file, kind, chosen);
  }
}

void add_abstat(BinoutWriter& binout, const std::vector<LegendEntry>& titles, double time,
                std::span<const AirbagRow> airbags) {
  if (binout.begin_metadata("abstat")) {
    write_ids(binout.file(), airbags, &AirbagRow::airbag);
    binout.legend(titles);
  }
  binout.begin_state("abstat", time);
  write_columns(binout.file(), airbag_columns(), airbags);
}

void add_deforc(BinoutWriter& binout, double time, std::span<const SpringForce> springs) {
  if (binout.begin_metadata("deforc")) {
    write_ids(binout.file(), springs, &SpringForce::spring);
    binout.file().integers("irot", integers_of(springs, [](const SpringForce& s) { return s.torsional; }));
  }
  binout.begin_state("deforc", time);
  write_columns(binout.file(), spring_columns(), springs);
}

void add_jntforc(BinoutWriter& binout, double time, std::span<const JointForce> joints) {
  LsdaWriter& file = binout.file();
  if (binout.begin_metadata("jntforc/joints")) {
    write_ids(file, joints, &JointForce::joint);
    file.integers("local", integers_of(joints, [](const JointForce& j) { return j.local; }));
  }
  binout.begin_state("jntforc/joints", time);
  write_columns(file, joint_columns(), joints);
  file.reals("resultant_force", reals_of(joints, [](const JointForce& j) { return j.force.stableNorm(); }));
  file.reals("resultant_moment", reals_of(joints, [](const JointForce& j) { return j.moment.stableNorm(); }));
}

}  // namespace gapcheck::results
