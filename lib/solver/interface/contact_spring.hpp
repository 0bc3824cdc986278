#pragma once
#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/weak_cache.hpp"
#include "contact/pair/side_scene.hpp"
#include "contact/stiffness/segment_spring.hpp"

namespace gapcheck::solver {

/// Which stiffness the springs of SOFT = 0 have. Source: contact rules, sections 6.1 and 12.3.
enum class SpringFormula : std::uint8_t {
  documented,  ///< shells K A / longest diagonal; a node has the least of its segments
  /// As in the surface time step that LS-DYNA prints: shells K A / max(t, shorter diagonal); a node has the
  /// mean of its segments, by area. Beams as above.
  printed,
};

/// Masses and stiffness that all contacts of a model share.
struct ContactMasses {
  explicit ContactMasses(const model::Model& model, SpringFormula formula = SpringFormula::documented);
  /// As SegmentSprings does, by the formula.
  [[nodiscard]] contact::SegmentSpring spring(const contact::Segments& segments, std::size_t segment, double scale,
                                              double solid_modulus) const;
  contact::ElementSizes sizes;
  contact::SegmentSprings springs;
  std::vector<double> mass;  ///< by node; rigid parts count like others
  SpringFormula formula;
};

/// What the springs of one side's nodes and segments have in common, with SFS or SFM and SSF.
struct SideStiffness {
  struct Node {
    double least = 0;     ///< of the node's segments; by the printed formula their mean
    double weighted = 0;  ///< mean of them, by area
    double thickness = 0;
  };
  std::vector<Node> nodes;       ///< by slot
  std::vector<double> segments;  ///< by segment
};

/// The tables in use of a model's contacts: those with the same side and scale share them.
class StiffnessCache {
 public:
  /// Of a side's nodes or of its segments; the other half is empty. `scale`: SLSFAC · SFS or SLSFAC · SFM;
  /// `solid_modulus`: SLDSTF of coated solids; `lines`: beam axes count at their nodes.
  [[nodiscard]] std::shared_ptr<const SideStiffness> nodes(const ContactMasses& masses,
                                                           const contact::ContactSide& side, double scale,
                                                           double solid_modulus, bool lines);
  [[nodiscard]] std::shared_ptr<const SideStiffness> segments(const ContactMasses& masses,
                                                              const contact::ContactSide& side, double scale,
                                                              double solid_modulus);

 private:
  struct Key {
    const contact::ContactSide* side;
    std::uint64_t scale, solid_modulus;
    bool nodes, lines;
    auto operator<=>(const Key&) const = default;
  };
  WeakCache<Key, SideStiffness> tables_;
};

/// Stiffness of the springs between the tracked nodes and the segments of one scene. Everything except SOFT = 1 is
/// known at the start. The formulas are those of contact/stiffness.hpp.
class ContactSprings {
 public:
  /// `node_scale`, `segment_scale`: SFS or SFM of the tracked and of the reference side. `shared`: tables of the
  /// model's other contacts, not needed afterwards.
  ContactSprings(const model::Model& model, const contact::SideScene& side, const ContactMasses& masses,
                 double node_scale, double segment_scale, StiffnessCache& shared);
  /// The step used by SOFT = 1: that of the first cycle, or DTSTIF.
  void set_timestep(double timestep) { timestep_ = timestep; }

  struct Spring {
    double stiffness = 0;
    double node_mass = 0, segment_mass = 0;  ///< mass of the node and of all the segment's nodes
  };
  [[nodiscard]] Spring operator()(SlotIndex slot, SegmentIndex segment) const;
  /// Damping constant at VDC percent of the critical one: VDC / 100 · 2 m ω. Source: contact rules, section 8.3.
  [[nodiscard]] static double damping(const Spring& spring, double percent);

 private:
  const contact::PairScene& scene_;
  const std::vector<double>& mass_;
  std::int64_t penopt_, soft_;
  double sofscl_, timestep_ = 0;
  std::shared_ptr<const SideStiffness> nodes_, segments_;  ///< of the tracked and of the reference side
};

}  // namespace gapcheck::solver
