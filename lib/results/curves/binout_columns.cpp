#include "results/curves/binout_columns.hpp"

#include <fmt/format.h>

namespace gapcheck::results {

const BinoutColumns<SectionState>& section_columns() {
  using Row = SectionState;
  static const BinoutColumns<Row> columns{
      &Row::section,
      {{"?_force", &Row::force}, {"?_moment", &Row::moment}, {"?_centroid", &Row::centroid}},
      {{"area", &Row::area}}};
  return columns;
}

const BinoutColumns<SupportState>& support_force_columns() {
  static const BinoutColumns<SupportState> columns{&SupportState::node, {{"?_force", &SupportState::force}}, {}};
  return columns;
}

const BinoutColumns<SupportState>& support_moment_columns() {
  static const BinoutColumns<SupportState> columns{&SupportState::node, {{"?_moment", &SupportState::moment}}, {}};
  return columns;
}

const BinoutColumns<BoundaryState>& boundary_columns(bool moments, bool old) {
  using Row = BoundaryState;
  using Columns = BinoutColumns<Row>;
  static const Columns forces{&Row::id, {{"?_force", &Row::force}}, {{"energy", &Row::energy}}},
      both{&Row::id, {{"?_force", &Row::force}, {"?moment", &Row::moment}}, {{"energy", &Row::energy}}},
      of_old_files{&Row::id, {{"?force", &Row::force}, {"?moment", &Row::moment}}, {{"energy", &Row::energy}}};
  return old ? of_old_files : moments ? both : forces;
}

const BinoutColumns<WallForce>& wall_columns() {
  static const BinoutColumns<WallForce> columns{
      &WallForce::wall, {{"?_force", &WallForce::force}}, {{"normal_force", &WallForce::normal}}};
  return columns;
}

const BinoutColumns<BodyMotion>& body_columns() {
  using Row = BodyMotion;
  static const BinoutColumns<Row> columns{&Row::body,
                                          {{"global_d?", &Row::displacement},
                                           {"global_?", &Row::position},
                                           {"global_rd?", &Row::rotation},
                                           {"global_v?", &Row::velocity},
                                           {"global_rv?", &Row::spin},
                                           {"global_a?", &Row::acceleration},
                                           {"global_ra?", &Row::spin_rate}},
                                          {}};
  return columns;
}

const BinoutColumns<WeldForce>& weld_columns() {
  using Row = WeldForce;
  static const BinoutColumns<Row> columns{&Row::id,
                                          {},
                                          {{"axial", &Row::axial},
                                           {"shear", &Row::shear},
                                           {"failure_time", &Row::failure_time},
                                           {"length", &Row::length},
                                           {"resultant_moment", &Row::moment},
                                           {"torsion", &Row::torsion}}};
  return columns;
}

const BinoutColumns<SpringForce>& spring_columns() {
  using Row = SpringForce;
  static const BinoutColumns<Row> columns{
      &Row::spring, {{"?_force", &Row::force}}, {{"resultant_force", &Row::resultant}, {"displacement", &Row::change}}};
  return columns;
}

const BinoutColumns<AirbagRow>& airbag_columns() {
  using Row = AirbagRow;
  static const BinoutColumns<Row> columns{&Row::airbag,
                                          {},
                                          {{"volume", &Row::volume},
                                           {"pressure", &Row::pressure},
                                           {"internal_energy", &Row::energy},
                                           {"dm_dt_in", &Row::rate_in},
                                           {"density", &Row::density},
                                           {"dm_dt_out", &Row::rate_out},
                                           {"total_mass", &Row::mass},
                                           {"gas_temp", &Row::temperature},
                                           {"surface_area", &Row::area}}};
  return columns;
}

const BinoutColumns<JointForce>& joint_columns() {
  using Row = JointForce;
  static const BinoutColumns<Row> columns{&Row::joint, {{"?_force", &Row::force}, {"?_moment", &Row::moment}}, {}};
  return columns;
}

std::string axis_array(int row, int column) { return fmt::format("dircos_{}{}", row, column); }

std::string boundary_branch(BoundaryKind kind, bool body) {
  if (kind == BoundaryKind::pressure) return "bndout/pressure";
  return fmt::format("bndout/{}/{}", name(kind), body ? "rigidbodies" : "nodes");
}

std::string element_branch(StressKind kind) { return fmt::format("elout/{}", name(kind)); }

}  // namespace gapcheck::results
