#include "solver/output/section_states.hpp"

namespace gapcheck::solver {
namespace {

using CutKind = CutSection::Kind;

/// The sums over one section.
class SectionSum {
 public:
  SectionSum(const Run& run, const ElementPlaces& places)
      : structure_(run.stepper().structure()), places_(places), x_(structure_.state.x) {}

  /// Area and centroid; without an area the mean of the points.
  void add_patches(const CutSection& cut) {
    Vector moment = Vector::Zero(), mean = Vector::Zero();
    std::size_t points = 0;
    for (const CutSection::Patch& patch : cut.patches) {
      if (place(patch.kind, patch.element) == no_position) continue;
      for (const CutSection::EdgePoint& point : patch.points) mean += at(point);
      points += patch.points.size();
      add_patch(patch, moment);
    }
    if (area_ > 0)
      centroid_ = moment / area_;
    else if (points > 0)
      centroid_ = mean / static_cast<double>(points);
  }

  void add_forces(const CutSection& cut) {
    for (const CutKind kind : {CutKind::shell, CutKind::solid, CutKind::beam})
      for (const auto& [element, corners] : cut.elements[static_cast<std::size_t>(kind)]) {
        const std::uint32_t i = place(kind, element);
        if (i == no_position) continue;
        for (std::size_t k = 0; k < 8; ++k)
          if ((corners >> k & 1u) != 0) add_corner(kind, i, k);
      }
  }

  [[nodiscard]] results::SectionState state() const { return {0, force_, moment_, centroid_, area_}; }

 private:
  /// In the structure; no_position: it has no forces.
  [[nodiscard]] std::uint32_t place(CutKind kind, std::uint32_t element) const {
    const std::uint32_t i = kind == CutKind::shell   ? places_.shells[element]
                            : kind == CutKind::solid ? places_.solids[element]
                                                     : places_.beams[element];
    if (i == no_position) return i;
    const bool failed = kind == CutKind::shell   ? structure_.shells.failed(i)
                        : kind == CutKind::solid ? structure_.solids.failed(i)
                                                 : structure_.beams.failed(i);
    return failed ? no_position : i;
  }

  [[nodiscard]] Vector at(const CutSection::EdgePoint& point) const {
    return x_[point.a.value] + point.share * (x_[point.b.value] - x_[point.a.value]);
  }

  void add_patch(const CutSection::Patch& patch, Vector& moment) {
    const auto add = [&](double area, const Vector& centre) {
      area_ += area;
      moment += area * centre;
    };
    const std::uint32_t i = place(patch.kind, patch.element);
    if (patch.points.empty()) return;
    const Vector first = at(patch.points[0]);
    if (patch.kind == CutKind::beam) return add(structure_.beams.properties(i).section.area, first);
    if (patch.kind == CutKind::shell) {
      if (patch.points.size() < 2) return;
      const Vector second = at(patch.points[1]);
      return add((second - first).norm() * structure_.shells.state(i).thickness, (first + second) / 2);
    }
    for (std::size_t k = 2; k < patch.points.size(); ++k) {
      const Vector second = at(patch.points[k - 1]), third = at(patch.points[k]);
      add((second - first).cross(third - first).norm() / 2, (first + second + third) / 3);
    }
  }

  void add_corner(CutKind kind, std::uint32_t i, std::size_t k) {
    if (kind == CutKind::shell) {
      if (k < structure_.shells.corners(i))
        add_pull(structure_.shells.nodes(i)[k], structure_.shells.corner_force(i, k),
                 structure_.shells.corner_moment(i, k));
    } else if (kind == CutKind::solid) {
      add_pull(structure_.solids.nodes(i)[k], structure_.solids.corner_force(i, k), Vector::Zero());
    } else {
      add_pull(structure_.beams.nodes(i)[k], structure_.beams.end_force(i, k), structure_.beams.end_moment(i, k));
    }
  }

  /// Elements pull their nodes with the opposite of their internal forces.
  void add_pull(NodeIndex node, const Vector& force, const Vector& moment) {
    force_ -= force;
    moment_ -= moment + (x_[node.value] - centroid_).cross(force);
  }

  const Structure& structure_;
  const ElementPlaces& places_;
  const std::vector<Vector>& x_;
  Vector force_ = Vector::Zero(), moment_ = Vector::Zero(), centroid_ = Vector::Zero();
  double area_ = 0;
};

}  // namespace

results::SectionState section_state(const Run& run, const ElementPlaces& places, const CutSection& cut) {
  SectionSum sum(run, places);
  sum.add_patches(cut);
  sum.add_forces(cut);
  results::SectionState state = sum.state();
  state.section = run.model().cross_sections[cut.section].id;
  return state;
}

std::vector<results::SectionState> section_states(const Run& run, const ElementPlaces& places,
                                                  const std::vector<CutSection>& cuts) {
  std::vector<results::SectionState> states;
  for (const CutSection& cut : cuts)
    if (cut.fault.empty()) states.push_back(section_state(run, places, cut));
  return states;
}

}  // namespace gapcheck::solver
