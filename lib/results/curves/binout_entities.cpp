#include "results/curves/binout_entities.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace gapcheck::results {
namespace {

/// An array of a state, and what it is in curves.
struct EntityArray {
  std::string_view array, quantity, name;
  bool last_axis = false;  ///< with the two before it a vector, which has a resultant
};

/// Where the entities of a kind lie in a binout. Names after LS-DYNA's files and what LS-DYNA's l2a and other readers
/// of binouts expect.
struct EntityBranch {
  std::string_view branch, kind;
  std::string_view ids;  ///< none: one entity without an id
  std::span<const EntityArray> arrays;
  int digits = 5;          ///< that the text file prints
  bool points = false;     ///< elements have several values of each, one after the other
  std::int64_t type = -1;  ///< only the entities of this type; -1: all
};

constexpr std::array<EntityArray, 6> section_arrays{{{"x_force", "force", "x-force"},
                                                     {"y_force", "force", "y-force"},
                                                     {"z_force", "force", "z-force", true},
                                                     {"x_moment", "moment", "x-moment"},
                                                     {"y_moment", "moment", "y-moment"},
                                                     {"z_moment", "moment", "z-moment", true}}};
constexpr std::span<const EntityArray> force_arrays = std::span(section_arrays).first(3);
constexpr std::span<const EntityArray> moment_arrays = std::span(section_arrays).last(3);
constexpr std::array<EntityArray, 3> total_arrays{{{"x_resultant", "force", "x-force"},
                                                   {"y_resultant", "force", "y-force"},
                                                   {"z_resultant", "force", "z-force", true}}};
constexpr std::array<EntityArray, 7> boundary_arrays{{{"x_force", "force", "x-force"},
                                                      {"y_force", "force", "y-force"},
                                                      {"z_force", "force", "z-force", true},
                                                      {"xforce", "force", "x-force"},  // of old files
                                                      {"yforce", "force", "y-force"},
                                                      {"zforce", "force", "z-force", true},
                                                      {"energy", "energy", "energy"}}};
constexpr std::array<EntityArray, 4> wall_arrays{{{"normal_force", "force", "normal force"},
                                                  {"x_force", "force", "x-force"},
                                                  {"y_force", "force", "y-force"},
                                                  {"z_force", "force", "z-force", true}}};
constexpr std::array<EntityArray, 9> body_arrays{{{"global_dx", "displacement", "x-displacement"},
                                                  {"global_dy", "displacement", "y-displacement"},
                                                  {"global_dz", "displacement", "z-displacement", true},
                                                  {"global_vx", "velocity", "x-velocity"},
                                                  {"global_vy", "velocity", "y-velocity"},
                                                  {"global_vz", "velocity", "z-velocity", true},
                                                  {"global_rdx", "rotation", "x-rotation"},
                                                  {"global_rdy", "rotation", "y-rotation"},
                                                  {"global_rdz", "rotation", "z-rotation", true}}};
constexpr std::array<EntityArray, 2> weld_arrays{
    {{"axial", "force", "axial force"}, {"shear", "force", "shear force"}}};
constexpr std::array<EntityArray, 6> beam_arrays{{{"axial", "force", "axial force"},
                                                  {"shear_s", "force", "shear force s"},
                                                  {"shear_t", "force", "shear force t"},
                                                  {"moment_s", "moment", "moment s"},
                                                  {"moment_t", "moment", "moment t"},
                                                  {"torsion", "moment", "torsion"}}};
constexpr std::array<EntityArray, 7> stress_arrays{{{"sig_xx", "stress", "xx-stress"},
                                                    {"sig_yy", "stress", "yy-stress"},
                                                    {"sig_zz", "stress", "zz-stress"},
                                                    {"sig_xy", "stress", "xy-stress"},
                                                    {"sig_yz", "stress", "yz-stress"},
                                                    {"sig_zx", "stress", "zx-stress"},
                                                    {"plastic_strain", "strain", "plastic strain"}}};
constexpr std::array<EntityArray, 5> spring_arrays{{{"x_force", "force", "x-force"},
                                                    {"y_force", "force", "y-force"},
                                                    {"z_force", "force", "z-force"},
                                                    {"resultant_force", "force", "resultant force"},
                                                    {"displacement", "displacement", "change in length"}}};

constexpr std::array<EntityBranch, 19> entity_branches{{
    {"secforc", "section", "ids", section_arrays},
    {"spcforc", "node", "force_ids", force_arrays},
    {"spcforc", "node", "moment_ids", moment_arrays},
    {"spcforc", "all nodes", "", total_arrays},
    {"bndout/discrete/nodes", "discrete node", "ids", boundary_arrays},
    {"bndout/discrete/rigidbodies", "discrete body", "ids", boundary_arrays},
    {"bndout/pressure", "pressure node", "ids", boundary_arrays},
    {"bndout/velocity/nodes", "velocity node", "ids", boundary_arrays},
    {"bndout/velocity/rigidbodies", "velocity body", "ids", boundary_arrays},
    {"rwforc/forces", "wall", "ids", wall_arrays, 7},
    {"rbdout", "body", "ids", body_arrays},
    {"swforc", "constraint/weld", "ids", weld_arrays, 6, false, 0},
    {"swforc", "generalized weld", "ids", weld_arrays, 6, false, 1},
    {"swforc", "spotweld beam", "ids", weld_arrays, 6, false, 2},
    {"swforc", "spotweld solid", "ids", weld_arrays, 6, false, 3},
    {"elout/beam", "beam", "ids", beam_arrays, 4},
    {"elout/shell", "shell", "ids", stress_arrays, 4, true},
    {"elout/solid", "solid", "ids", stress_arrays, 4, true},
    {"deforc", "spring", "ids", spring_arrays},
}};

/// The arrays that have values, each for `points` points of every entity.
struct FilledArrays {
  std::vector<const EntityArray*> arrays;
  std::size_t points = 1;
};

FilledArrays filled_arrays(const EntityBranch& source, const BinoutRow& row, std::size_t count) {
  FilledArrays filled;
  for (const EntityArray& entry : source.arrays) {
    const std::size_t size = row.size_of(entry.array);
    if (size == 0 || size % count != 0 || !row.has_columns({entry.array}, size)) continue;
    const std::size_t points = size / count;
    if (points > 1 && !source.points) continue;
    if (filled.arrays.empty()) filled.points = points;
    if (points == filled.points) filled.arrays.push_back(&entry);
  }
  return filled;
}

/// Array k is the last axis of a vector whose other axes are there.
bool ends_vector(const FilledArrays& filled, std::size_t k) {
  return filled.arrays[k]->last_axis && k >= 2 && filled.arrays[k - 2] + 2 == filled.arrays[k];
}

std::vector<EntityHistory::Column> columns_of(const EntityBranch& source, const FilledArrays& filled) {
  std::vector<EntityHistory::Column> columns;
  for (std::size_t point = 1; point <= filled.points; ++point) {
    const std::string where = source.points ? fmt::format("point {} ", point) : "";
    for (std::size_t k = 0; k < filled.arrays.size(); ++k) {
      const EntityArray& entry = *filled.arrays[k];
      columns.push_back({std::string(entry.quantity), fmt::format("{}{}", where, entry.name)});
      if (ends_vector(filled, k))
        columns.push_back({std::string(entry.quantity), fmt::format("{}resultant {}", where, entry.quantity)});
    }
  }
  return columns;
}

/// The values of entity i, in the order of the columns.
void add_values(const FilledArrays& filled, const BinoutRow& row, std::size_t count, std::size_t i,
                std::vector<double>& values) {
  for (std::size_t point = 0; point < filled.points; ++point)
    for (std::size_t k = 0; k < filled.arrays.size(); ++k) {
      values.push_back(row.column(filled.arrays[k]->array, count * filled.points).at(i * filled.points + point));
      if (!ends_vector(filled, k)) continue;
      const std::size_t end = values.size();
      values.push_back(Vector(values[end - 3], values[end - 2], values[end - 1]).stableNorm());
    }
}

/// The history of the branch with these columns; nothing if it has others.
EntityHistory* history_of(const EntityBranch& source, std::vector<EntityHistory::Column> columns,
                          std::vector<EntityHistory>& histories) {
  const std::string file(source.branch.substr(0, source.branch.find('/')));
  for (EntityHistory& history : histories) {
    if (history.file != file || history.kind != source.kind) continue;
    // Nodes of spcforc have two: one of forces, one of moments.
    if (history.columns[0].quantity != columns[0].quantity) continue;
    return history.columns.size() == columns.size() ? &history : nullptr;
  }
  histories.push_back({file, std::string(source.kind), source.digits, std::move(columns), {}});
  return &histories.back();
}

bool add_entities(const EntityBranch& source, const BinoutMeta& meta, const BinoutRow& row,
                  std::vector<EntityHistory>& histories) {
  EntityState state;
  state.time = row.number("time", std::numeric_limits<double>::quiet_NaN());
  if (!std::isfinite(state.time)) return false;
  const bool single = source.ids.empty(), own_ids = row.has(source.ids), spcforc = source.branch == "spcforc";
  const std::size_t count = single ? 1 : own_ids ? row.size_of(source.ids) : meta.list(source.ids).size();
  if (count == 0) return spcforc || own_ids || meta.has(source.ids);
  const FilledArrays filled = filled_arrays(source, row, count);
  if (filled.arrays.empty()) return single;
  const std::vector<std::int64_t> ids = single    ? std::vector<std::int64_t>{0}
                                        : own_ids ? row.integers(source.ids)
                                                  : meta.list(source.ids);
  const std::vector<std::int64_t>& types = meta.list("types");
  for (std::size_t i = 0; i < count; ++i) {
    if (source.type >= 0 && (i < types.size() ? types[i] : 0) != source.type) continue;
    state.ids.push_back(ids[i]);
    add_values(filled, row, count, i, state.values);
  }
  if (state.ids.empty()) return true;
  EntityHistory* history = history_of(source, columns_of(source, filled), histories);
  if (history == nullptr) return false;
  history->states.push_back(std::move(state));
  return true;
}

}  // namespace

bool is_entity_branch(std::string_view branch) {
  return std::any_of(entity_branches.begin(), entity_branches.end(),
                     [&](const EntityBranch& source) { return source.branch == branch; });
}

bool add_entity_state(std::string_view branch, const BinoutMeta& meta, const BinoutRow& row,
                      std::vector<EntityHistory>& histories) {
  bool complete = true;
  for (const EntityBranch& source : entity_branches)
    if (source.branch == branch) complete = add_entities(source, meta, row, histories) && complete;
  return complete;
}

}  // namespace gapcheck::results
