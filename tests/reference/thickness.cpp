// Contact thickness: contact rules, section 4.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/surfaces.hpp"

namespace gapcheck::reference {
namespace {

using model::Family;

/// 4.4: which value of SHLTHK counts.
int shlthk_that_counts(const Contact& contact, const Controls& controls) {
  if (contact.thkopt == 1) return contact.shlthk;
  return contact.thkopt == 2 ? 0 : controls.shlthk;
}

/// 4.4: old types count shells as SHLTHK says, forming ones deformable shells always.
int counted_shells(const Rules& rules) {
  const int given = shlthk_that_counts(rules.contact, rules.controls);
  if (rules.kind.family == Family::old) return given;
  if (rules.kind.family == Family::forming) return given == 2 ? 2 : 1;
  return 2;
}

double shortest_edge(const Element& element, const Positions& x) {
  double shortest = std::numeric_limits<double>::max();
  const std::size_t count = element.nodes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = element.nodes[i], b = element.nodes[(i + 1) % count];
    if (a != b) shortest = std::min(shortest, (x[std::size_t(a)] - x[std::size_t(b)]).norm());
  }
  return shortest;
}

bool ignored(const Rules& rules, Which which, const Element& element, const Part& part) {
  if (element.kind != Kind::shell) return false;
  // 4.4: IGNROFF takes the thickness of side B (1), side A (2) or both (3).
  const int ignroff = rules.contact.ignroff;
  if (ignroff == 3 || ignroff == (which == Which::b ? 1 : 2)) return true;
  return rules.shlthk < (part.rigid ? 2 : 1);
}

}  // namespace

Rules::Rules(const Contact& c, const Scene& scene)
    : contact(c), controls(scene.controls), kind(*model::find_contact_kind(c.name)) {
  single = kind.treatment == model::Treatment::single_surface;
  two_way = kind.treatment == model::Treatment::two_way;
  // 7.4, 7.5: only some types have SOFT = 2 (1.5), the others take it as 1.
  const bool soft_2 = c.soft == 2 && kind.can(model::Ability::soft_2);
  by_segments = c.mortar || soft_2;
  oriented = !by_segments && (kind.family == Family::old || kind.family == Family::forming);
  edge_limit = single && controls.ssthk == 0 && !kind.ties();
  shlthk = counted_shells(*this);
  // 3.3
  const bool square = soft_2 && (c.shledg == 1 || (c.shledg == 0 && controls.shledg == 1));
  free_edges_end = c.mortar || c.srnde == 1 || c.srnde == 2 || square;
}

double uncounted_thickness(const Scene& scene, const Element& element) {
  const Part& part = scene.part(element.part);
  if (element.kind == Kind::beam) return part.diameter;
  if (element.kind == Kind::solid) return 0;
  const std::size_t count = element.nodes[2] == element.nodes[3] ? 3 : 4;
  double sum = 0;  // 4.1: the mean of the corners
  for (std::size_t i = 0; i < count; ++i) sum += element.own[i] != 0 ? element.own[i] : part.thickness;
  return sum / double(count);
}

double contact_thickness(const Scene& scene, const Rules& rules, Which which, const Element& element,
                         const Positions& x) {
  const Part& part = scene.part(element.part);
  if (element.kind == Kind::solid || ignored(rules, which, element, part)) return 0;
  const Contact& c = rules.contact;
  // 4.2, in this order
  if (part.optt > 0) return part.optt;
  const double given = std::abs(which == Which::a ? c.sst : c.mst);
  if (given > 0) return given;
  if (rules.controls.th > 0) return rules.controls.th;
  double t = uncounted_thickness(scene, element);
  t *= part.sft > 0 ? part.sft : which == Which::a ? c.sfst : c.sfmt;
  if (rules.controls.th_sf > 0) t *= rules.controls.th_sf;
  return rules.edge_limit && element.kind == Kind::shell ? std::min(t, 0.4 * shortest_edge(element, x)) : t;  // 4.3
}

}  // namespace gapcheck::reference
