#pragma once
#include <cstdint>
#include <vector>

#include "contact/pair/side_scene.hpp"
#include "contact/stiffness/segment_spring.hpp"

namespace gapcheck::solver {

/// Masses and stiffness that all contacts of a model share.
struct ContactMasses {
  explicit ContactMasses(const model::Model& model);
  contact::ElementSizes sizes;
  contact::SegmentSprings springs;
  std::vector<double> mass;  ///< by node; rigid parts count like others
};

/// Stiffness of the springs between the tracked nodes and the segments of one scene. Everything except SOFT = 1 is
/// known at the start. The formulas are those of contact/stiffness.hpp.
class ContactSprings {
 public:
  /// `node_scale`, `segment_scale`: SFS or SFM of the tracked and of the reference side.
  ContactSprings(const model::Model& model, const contact::SideScene& side, const ContactMasses& masses,
                 double node_scale, double segment_scale);
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
  /// including SFS, SFM and SSF
  struct Node {
    double least = 0;     ///< of the node's segments
    double weighted = 0;  ///< mean of them, by area
    double thickness = 0;
  };
  const contact::PairScene& scene_;
  const std::vector<double>& mass_;
  std::int64_t penopt_, soft_;
  double sofscl_, timestep_ = 0;
  std::vector<Node> nodes_;       // by slot
  std::vector<double> segments_;  // by segment
};

}  // namespace gapcheck::solver
