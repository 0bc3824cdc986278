#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "results/curves/binout_row.hpp"
#include "results/curves/lsda_write.hpp"
#include "results/history/airbag_states.hpp"
#include "results/history/body_motion.hpp"
#include "results/history/boundary_forces.hpp"
#include "results/history/element_stress.hpp"
#include "results/history/joint_forces.hpp"
#include "results/history/section_forces.hpp"
#include "results/history/spring_forces.hpp"
#include "results/history/support_forces.hpp"
#include "results/history/wall_forces.hpp"
#include "results/history/weld_forces.hpp"

namespace gapcheck::results {

/// Which arrays of a branch hold which numbers of its rows; the same table is for writing and for reading.
template <class Row>
struct BinoutColumns {
  struct OfVector {
    std::string_view pattern;  ///< "?_force": x_force, y_force, z_force
    Vector Row::*member;
  };
  struct OfNumber {
    std::string_view name;
    double Row::*member;
  };
  std::int64_t Row::*id;
  std::vector<OfVector> vectors;  ///< a state needs the first one; others are zero where they are missing
  std::vector<OfNumber> numbers;  ///< the same where there are no vectors
};

/// "x_force" of "?_force".
[[nodiscard]] inline std::string axis_name(std::string_view pattern, int axis) {
  std::string name(pattern);
  name[name.find('?')] = "xyz"[axis];
  return name;
}

/// The arrays of a state.
template <class Row>
void write_columns(LsdaWriter& file, const BinoutColumns<Row>& columns, std::span<const Row> rows) {
  std::vector<double> values(rows.size());
  for (const auto& [pattern, member] : columns.vectors)
    for (const int axis : {0, 1, 2}) {
      for (std::size_t i = 0; i < rows.size(); ++i) values[i] = (rows[i].*member)[axis];
      file.reals(axis_name(pattern, axis), values);
    }
  for (const auto& [name, member] : columns.numbers) {
    for (std::size_t i = 0; i < rows.size(); ++i) values[i] = rows[i].*member;
    file.reals(name, values);
  }
}

/// A row for each id; nothing if what a state needs is missing or has another size.
template <class Row>
std::optional<std::vector<Row>> read_columns(const BinoutColumns<Row>& columns, std::span<const std::int64_t> ids,
                                             const BinoutRow& state) {
  const std::size_t count = ids.size();
  if (count == 0) return std::vector<Row>();
  const auto has = [&](const std::string& name) { return state.has_columns({name}, count); };
  for (const int axis : {0, 1, 2})
    if (!columns.vectors.empty() && !has(axis_name(columns.vectors[0].pattern, axis))) return std::nullopt;
  if (columns.vectors.empty() && !has(std::string(columns.numbers.at(0).name))) return std::nullopt;
  std::vector<Row> rows(count);
  for (std::size_t i = 0; i < count; ++i) rows[i].*columns.id = ids[i];
  for (const auto& [pattern, member] : columns.vectors)
    for (const int axis : {0, 1, 2}) {
      const BinoutColumn column = state.column(axis_name(pattern, axis), count);
      for (std::size_t i = 0; i < count; ++i) (rows[i].*member)[axis] = column.at(i);
    }
  for (const auto& [name, member] : columns.numbers) {
    const BinoutColumn column = state.column(name, count);
    for (std::size_t i = 0; i < count; ++i) rows[i].*member = column.at(i);
  }
  return rows;
}

// The names are those of LS-DYNA, as its own converter from binout to text (l2a) reads them.
[[nodiscard]] const BinoutColumns<SectionState>& section_columns();
[[nodiscard]] const BinoutColumns<SupportState>& support_force_columns();
[[nodiscard]] const BinoutColumns<SupportState>& support_moment_columns();
/// `moments`: of rigid bodies with prescribed motions; `old`: the names of old files.
[[nodiscard]] const BinoutColumns<BoundaryState>& boundary_columns(bool moments, bool old = false);
[[nodiscard]] const BinoutColumns<WallForce>& wall_columns();
[[nodiscard]] const BinoutColumns<BodyMotion>& body_columns();
[[nodiscard]] const BinoutColumns<WeldForce>& weld_columns();
[[nodiscard]] const BinoutColumns<SpringForce>& spring_columns();
[[nodiscard]] const BinoutColumns<JointForce>& joint_columns();
[[nodiscard]] const BinoutColumns<AirbagRow>& airbag_columns();

/// Row and column of an axis of a body, from 1: "dircos_12".
[[nodiscard]] std::string axis_array(int row, int column);

/// Where bndout has the forces of a kind: "bndout/velocity/nodes".
[[nodiscard]] std::string boundary_branch(BoundaryKind kind, bool body);

/// Where elout has the elements of a kind: "elout/solid".
[[nodiscard]] std::string element_branch(StressKind kind);

}  // namespace gapcheck::results
