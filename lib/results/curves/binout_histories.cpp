#include "results/curves/binout_histories.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "results/curves/binout_columns.hpp"

namespace gapcheck::results {
namespace {

/// A state of a branch while it is read.
struct BinoutSource {
  const BinoutMeta& meta;
  const BinoutRow& row;
  double time;

  /// Of the state itself, or of all states.
  [[nodiscard]] std::vector<std::int64_t> list(std::string_view name) const {
    return row.has(name) ? row.integers(name) : meta.list(name);
  }
  template <class Row>
  [[nodiscard]] std::optional<std::vector<Row>> rows(const BinoutColumns<Row>& columns) const {
    return read_columns<Row>(columns, list("ids"), row);
  }
};

/// Rows at one time. False: they could not be read.
template <class Row>
bool add_rows(const BinoutSource& source, std::optional<std::vector<Row>> rows, History<Row>& history) {
  if (!rows.has_value()) return false;
  if (!rows->empty()) history.at(source.time);
  for (Row& row : *rows) history.add(std::move(row));
  return true;
}

/// For rows that flags of all ids change.
template <class Row, class Change>
bool add_flagged(const BinoutSource& source, std::string_view flags, std::optional<std::vector<Row>> rows,
                 History<Row>& history, const Change& change) {
  const std::vector<std::int64_t>& list = source.meta.list(flags);
  for (std::size_t i = 0; rows && i < std::min(rows->size(), list.size()); ++i) change((*rows)[i], list[i]);
  return add_rows(source, std::move(rows), history);
}

/// By node as the text has them: forces and moments in one row, and the sum of the forces as node 0.
bool add_supports(const BinoutSource& source, RunResults& run) {
  auto rows = read_columns<SupportState>(support_force_columns(), source.meta.list("force_ids"), source.row);
  const auto moments = read_columns<SupportState>(support_moment_columns(), source.meta.list("moment_ids"), source.row);
  if (!rows || !moments) return false;
  std::map<std::int64_t, std::size_t> place;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    (*rows)[i].translation = true;
    place.emplace((*rows)[i].node, i);
  }
  for (const SupportState& moment : *moments) {
    const auto [found, is_new] = place.try_emplace(moment.node, rows->size());
    if (is_new) rows->emplace_back().node = moment.node;
    (*rows)[found->second].rotation = true;
    (*rows)[found->second].moment = moment.moment;
  }
  std::stable_sort(rows->begin(), rows->end(),
                   [](const SupportState& a, const SupportState& b) { return a.node < b.node; });
  if (source.row.has("x_resultant"))
    rows->push_back({0, true, false, source.row.vectors("resultant", 1).at(0), Vector::Zero()});
  return add_rows(source, std::move(rows), run.spcforc);
}

bool add_boundary(const BinoutSource& source, BoundaryKind kind, bool body, RunResults& run) {
  auto rows = source.rows(boundary_columns(body && kind == BoundaryKind::velocity, source.row.has("xforce")));
  for (std::size_t i = 0; rows && i < rows->size(); ++i) {
    (*rows)[i].kind = kind;
    (*rows)[i].body = body;
  }
  return add_rows(source, std::move(rows), run.bndout);
}

/// The text names walls by "setid".
bool add_walls(const BinoutSource& source, RunResults& run) {
  return add_flagged(source, "setid", source.rows(wall_columns()), run.rwforc,
                     [](WallForce& wall, std::int64_t id) { wall.wall = id; });
}

/// Nodal rigid bodies come last.
bool add_bodies(const BinoutSource& source, RunResults& run) {
  auto rows = source.rows(body_columns());
  if (!rows) return false;
  const std::vector<std::int64_t> nodal = source.list("num_nodal");
  for (std::size_t i = 0; i < rows->size(); ++i) {
    BodyMotion& body = (*rows)[i];
    body.nodal = !nodal.empty() && static_cast<std::int64_t>(rows->size() - i) <= nodal[0];
    if (!source.row.has(axis_array(1, 1))) continue;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) body.axes(r, c) = source.row.column(axis_array(r + 1, c + 1), rows->size()).at(i);
  }
  return add_rows(source, std::move(rows), run.rbdout);
}

bool add_welds(const BinoutSource& source, RunResults& run) {
  auto rows = source.rows(weld_columns());
  for (std::size_t i = 0; rows && i < rows->size(); ++i)
    (*rows)[i].failed = source.row.column("failure", rows->size()).at(i) >= 1;
  return add_flagged(source, "types", std::move(rows), run.swforc, [](WeldForce& weld, std::int64_t type) {
    if (type >= 0 && type <= static_cast<std::int64_t>(WeldForce::Kind::solid))
      weld.kind = static_cast<WeldForce::Kind>(type);
  });
}

/// How many of `size` values each element has: "nip", times "npl"; without these all have the same number. Empty: they
/// do not add up.
std::vector<std::size_t> point_counts(const BinoutRow& row, std::size_t count, std::size_t size) {
  std::vector<std::size_t> counts(count, size / count);
  if (row.has("nip")) {
    const std::vector<std::int64_t> layers = row.integers("nip"), points = row.integers("npl");
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t n = i < layers.size() ? layers[i] : 0, m = i < points.size() ? points[i] : 1;
      const auto most = static_cast<std::int64_t>(size);
      if (n < 0 || m < 0 || n > most || m > most) return {};
      counts[i] = static_cast<std::size_t>(n * m);
    }
  }
  std::size_t sum = 0;
  for (const std::size_t number : counts) sum += std::min(number, size + 1);
  return sum == size ? counts : std::vector<std::size_t>();
}

/// The points of all elements, one after the other.
class PointArrays {
 public:
  PointArrays(StressKind kind, const BinoutRow& row) : kind_(kind), row_(row), size_(row.size_of(array(0))) {
    for (std::size_t k = 0; k < components_.size(); ++k) columns_.push_back(row.column(array(k), size_));
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] StressRow at(std::size_t i) const {
    StressRow point;
    for (std::size_t k = 0; k < 6; ++k) point.stress[k] = columns_[k].at(i);
    point.plastic_strain = columns_[6].at(i);
    if (kind_ == StressKind::solid) point.effective = columns_[7].at(i);
    return point;
  }

 private:
  [[nodiscard]] std::string_view array(std::size_t k) const {
    if (kind_ == StressKind::beam) return beam_arrays[k];
    return k == 6 && kind_ == StressKind::solid ? "yield" : components_[k];
  }

  static constexpr std::array<std::string_view, 8> components_{"sig_xx", "sig_yy", "sig_zz",         "sig_xy",
                                                               "sig_yz", "sig_zx", "plastic_strain", "effsg"};
  static constexpr std::array<std::string_view, 8> beam_arrays{"sigma_11",    "", "", "sigma_12", "", "sigma_31",
                                                               "plastic_eps", ""};
  StressKind kind_;
  const BinoutRow& row_;
  std::size_t size_;
  std::vector<BinoutColumn> columns_;
};

/// Gives an element its points, in the order of the text: all layers of the first point in the plane, then of the next.
void take_points(const PointArrays& arrays, std::size_t first, std::size_t count, std::size_t layers,
                 ElementStress& element) {
  layers = layers > 0 && count % layers == 0 ? layers : std::max<std::size_t>(count, 1);
  if (element.kind == StressKind::shell) element.layers = layers;
  const std::size_t in_plane = count / layers;
  for (std::size_t point = 0; point < in_plane; ++point)
    for (std::size_t layer = 0; layer < layers; ++layer)
      element.points.push_back(arrays.at(first + layer * in_plane + point));
}

bool add_elements(const BinoutSource& source, StressKind kind, RunResults& run) {
  constexpr std::array<std::string_view, 6> resultants{"axial",    "shear_s",  "shear_t",
                                                       "moment_s", "moment_t", "torsion"};
  const std::vector<std::int64_t> ids = source.list("ids"),
                                  parts = source.list(kind == StressKind::solid ? "mtype" : "mat"),
                                  layers = source.row.integers("nip");
  if (ids.empty()) return true;  // all have failed
  const PointArrays arrays(kind, source.row);
  if (kind == StressKind::beam ? !source.row.has_columns({resultants[0]}, ids.size()) : arrays.size() == 0)
    return false;
  const std::vector<std::size_t> counts = point_counts(source.row, ids.size(), arrays.size());
  if (counts.empty()) return false;
  std::vector<ElementStress> rows;
  std::size_t first = 0;
  for (std::size_t i = 0; i < ids.size(); first += counts[i], ++i) {
    ElementStress& element = rows.emplace_back();
    element.kind = kind;
    element.id = ids[i];
    element.part = i < parts.size() ? parts[i] : 0;
    if (kind == StressKind::beam)
      for (std::size_t k = 0; k < resultants.size(); ++k)
        element.resultants[k] = source.row.column(resultants[k], ids.size()).at(i);
    take_points(arrays, first, counts[i], i < layers.size() ? static_cast<std::size_t>(layers[i]) : 0, element);
  }
  return add_rows(source, std::optional(std::move(rows)), run.elout);
}

bool add_springs(const BinoutSource& source, RunResults& run) {
  return add_flagged(source, "irot", source.rows(spring_columns()), run.deforc,
                     [](SpringForce& spring, std::int64_t irot) { spring.torsional = irot != 0; });
}

bool add_joints(const BinoutSource& source, RunResults& run) {
  return add_flagged(source, "local", source.rows(joint_columns()), run.jntforc,
                     [](JointForce& joint, std::int64_t local) { joint.local = local != 0; });
}

using AddHistory = std::function<bool(const BinoutSource&, RunResults&)>;

const std::map<std::string, AddHistory, std::less<>>& history_branches() {
  static const std::map<std::string, AddHistory, std::less<>> branches = [] {
    std::map<std::string, AddHistory, std::less<>> all{
        {"secforc",
         [](const BinoutSource& s, RunResults& run) { return add_rows(s, s.rows(section_columns()), run.secforc); }},
        {"spcforc", add_supports},
        {"rwforc/forces", add_walls},
        {"rbdout", add_bodies},
        {"swforc", add_welds},
        {"deforc", add_springs},
        {"abstat",
         [](const BinoutSource& s, RunResults& run) { return add_rows(s, s.rows(airbag_columns()), run.abstat); }},
        {"jntforc/joints", add_joints}};
    for (const BoundaryKind kind : {BoundaryKind::discrete, BoundaryKind::pressure, BoundaryKind::velocity})
      for (const bool body : {true, false})
        all[boundary_branch(kind, body)] = [=](const BinoutSource& source, RunResults& run) {
          return add_boundary(source, kind, body, run);
        };
    for (const StressKind kind : {StressKind::solid, StressKind::beam, StressKind::shell})
      all[element_branch(kind)] = [=](const BinoutSource& source, RunResults& run) {
        return add_elements(source, kind, run);
      };
    return all;
  }();
  return branches;
}

}  // namespace

bool is_history_branch(std::string_view branch) { return history_branches().find(branch) != history_branches().end(); }

bool add_history_state(std::string_view branch, const BinoutMeta& meta, const BinoutRow& row, RunResults& run) {
  const double time = row.number("time", std::numeric_limits<double>::quiet_NaN());
  const auto found = history_branches().find(branch);
  return found != history_branches().end() && std::isfinite(time) && found->second({meta, row, time}, run);
}

}  // namespace gapcheck::results
