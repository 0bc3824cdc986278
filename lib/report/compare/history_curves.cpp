#include "report/compare/history_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace gapcheck::report {
namespace {

/// Finds the curves of an entity, and creates them when it first appears.
class HistoryCurves {
 public:
  HistoryCurves(std::string file, int digits, std::vector<Curve>& list)
      : file_(std::move(file)), digits_(digits), list_(list) {}

  /// The entity that the next numbers belong to, always the same ones. `who`: "section 3".
  template <class Who>
  void entity(std::int64_t kind, std::int64_t id, double time, const Who& who) {
    time_ = time;
    const auto [place, is_new] = first_.try_emplace({kind, id}, list_.size());
    next_ = place->second;
    new_ = is_new;
    if (is_new) who_ = who();
  }
  void number(std::string_view quantity, std::string_view name, double value) {
    if (new_)
      list_.push_back({file_, std::string(quantity), fmt::format("{} {} {}", file_, who_, name), digits_, {}, {}, 0});
    list_[next_++].add(time_, value);
  }
  /// x, y, z and resultant.
  void vector(std::string_view quantity, const Vector& value) {
    for (int axis = 0; axis < 3; ++axis) number(quantity, fmt::format("{}-{}", "xyz"[axis], quantity), value[axis]);
    number(quantity, fmt::format("resultant {}", quantity), value.stableNorm());
  }

 private:
  std::string file_, who_;
  int digits_;
  std::vector<Curve>& list_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> first_;
  double time_ = 0;
  std::size_t next_ = 0;
  bool new_ = false;
};

/// Calls `add(curves, time, row)` for all rows of a file.
template <class Row, class Add>
void add_rows(const char* file, int digits, const results::History<Row>& history, std::vector<Curve>& list,
              const Add& add) {
  HistoryCurves curves(file, digits, list);
  for (const results::Timed<Row>& state : history.states)
    for (const Row& row : state.rows) add(curves, state.time, row);
}

void add_section(HistoryCurves& curves, double time, const results::SectionState& row) {
  curves.entity(0, row.section, time, [&] { return fmt::format("section {}", row.section); });
  curves.vector("force", row.force);
  curves.vector("moment", row.moment);
}

void add_support(HistoryCurves& curves, double time, const results::SupportState& row) {
  const std::string who = row.node == 0 ? std::string("all nodes") : fmt::format("node {}", row.node);
  if (row.translation) {
    curves.entity(0, row.node, time, [&] { return who; });
    curves.vector("force", row.force);
  }
  if (row.rotation) {
    curves.entity(1, row.node, time, [&] { return who; });
    curves.vector("moment", row.moment);
  }
}

void add_boundary(HistoryCurves& curves, double time, const results::BoundaryState& row) {
  curves.entity(2 * static_cast<std::int64_t>(row.kind) + (row.body ? 1 : 0), row.id, time,
                [&] { return fmt::format("{} {} {}", results::name(row.kind), row.body ? "body" : "node", row.id); });
  curves.vector("force", row.force);
  curves.number("energy", "energy", row.energy);
}

void add_wall(HistoryCurves& curves, double time, const results::WallForce& row) {
  curves.entity(0, row.wall, time, [&] { return fmt::format("wall {}", row.wall); });
  curves.number("force", "normal force", row.normal);
  curves.vector("force", row.force);
}

void add_body(HistoryCurves& curves, double time, const results::BodyMotion& row) {
  curves.entity(0, row.body, time, [&] { return fmt::format("body {}", row.body); });
  curves.vector("displacement", row.displacement);
  curves.vector("velocity", row.velocity);
  curves.vector("rotation", row.rotation);
}

void add_weld(HistoryCurves& curves, double time, const results::WeldForce& row) {
  curves.entity(static_cast<std::int64_t>(row.kind), row.id, time,
                [&] { return fmt::format("{} {}", results::name(row.kind), row.id); });
  curves.number("force", "axial force", row.axial);
  curves.number("force", "shear force", row.shear);
}

/// An element keeps the points that it has at first.
void add_element(HistoryCurves& curves, double time, const results::ElementStress& row) {
  const std::string who = fmt::format("{} {}", results::name(row.kind), row.id);
  const auto kind = static_cast<std::int64_t>(row.kind);
  if (row.kind == results::StressKind::beam) {
    curves.entity(kind, row.id, time, [&] { return who; });
    for (const auto& [at, quantity, name] : {std::tuple(0, "force", "axial force"),
                                             {1, "force", "shear force s"},
                                             {2, "force", "shear force t"},
                                             {3, "moment", "moment s"},
                                             {4, "moment", "moment t"},
                                             {5, "moment", "torsion"}})
      curves.number(quantity, name, row.resultants[static_cast<std::size_t>(at)]);
  }
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    curves.entity(3 + kind + 3 * static_cast<std::int64_t>(i), row.id, time,
                  [&] { return fmt::format("{} point {}", who, i + 1); });
    constexpr std::array<std::string_view, 6> names{"xx-stress", "yy-stress", "zz-stress",
                                                    "xy-stress", "yz-stress", "zx-stress"};
    for (std::size_t k = 0; k < names.size(); ++k) curves.number("stress", names[k], row.points[i].stress[k]);
    curves.number("strain", "plastic strain", row.points[i].plastic_strain);
  }
}

/// Translations and rotations have curves of their own.
void add_spring(HistoryCurves& curves, double time, const results::SpringForce& row) {
  curves.entity(row.torsional ? 1 : 0, row.spring, time, [&] { return fmt::format("spring {}", row.spring); });
  const std::string_view quantity = row.torsional ? "moment" : "force";
  for (int axis = 0; axis < 3; ++axis)
    curves.number(quantity, fmt::format("{}-{}", "xyz"[axis], quantity), row.force[axis]);
  curves.number(quantity, fmt::format("resultant {}", quantity), row.resultant);
  curves.number(row.torsional ? "rotation" : "displacement", row.torsional ? "relative rotation" : "change in length",
                row.change);
}

void add_joint(HistoryCurves& curves, double time, const results::JointForce& row) {
  curves.entity(0, row.joint, time, [&] { return fmt::format("joint {}", row.joint); });
  curves.vector("force", row.force);
  curves.vector("moment", row.moment);
}

void add_airbag(HistoryCurves& curves, double time, const results::AirbagRow& row) {
  curves.entity(0, row.airbag, time, [&] { return fmt::format("airbag {}", row.airbag); });
  curves.number("volume", "volume", row.volume);
  curves.number("pressure", "pressure", row.pressure);
  curves.number("energy", "internal energy", row.energy);
  curves.number("flow", "flow in", row.rate_in);
  curves.number("flow", "flow out", row.rate_out);
  curves.number("mass", "mass", row.mass);
  curves.number("temperature", "temperature", row.temperature);
}

/// One side of a contact, or a surface whose title names none.
void add_surfaces(const results::SurfaceHistory& history, std::vector<Curve>& list) {
  HistoryCurves curves("intfor", 6, list);
  for (const auto& [time, rows] : history.states)
    for (std::size_t i = 0; i < std::min(rows.size(), history.surfaces.size()); ++i) {
      const results::InterfaceSurface& surface = history.surfaces[i];
      curves.entity(0, static_cast<std::int64_t>(i), time, [&] {
        return surface.contact == 0 ? surface.title
                                    : fmt::format("contact {} side {}", surface.contact, "AB"[surface.side & 1]);
      });
      curves.number("pressure", "largest pressure", rows[i].largest_pressure);
      if (history.forces) curves.vector("force", {rows[i].force[0], rows[i].force[1], rows[i].force[2]});
    }
}

}  // namespace

void add_history_curves(const results::RunResults& run, std::vector<Curve>& list) {
  add_rows("secforc", 5, run.secforc, list, add_section);
  add_rows("spcforc", 5, run.spcforc, list, add_support);
  add_rows("bndout", 5, run.bndout, list, add_boundary);
  add_rows("rwforc", 7, run.rwforc, list, add_wall);
  add_rows("rbdout", 5, run.rbdout, list, add_body);
  add_rows("swforc", 6, run.swforc, list, add_weld);
  add_rows("elout", 4, run.elout, list, add_element);
  add_rows("deforc", 6, run.deforc, list, add_spring);
  add_rows("jntforc", 6, run.jntforc, list, add_joint);
  add_rows("abstat", 4, run.abstat, list, add_airbag);
  add_surfaces(run.intfor, list);
}

}  // namespace gapcheck::report
