#pragma once
#include <cstdint>
#include <vector>

#include "contact/definition/friction.hpp"
#include "contact/edge/edge_scene.hpp"
#include "solver/interface/contact_link.hpp"
#include "solver/interface/contact_setting.hpp"

namespace gapcheck::solver {

/// The springs between the edges of one contact. An edge is as stiff as its segment; SOFT = 1 uses the masses of the
/// edges' ends.
class EdgeSprings {
 public:
  /// `contact`: position in Model::contacts. `edges`: those of the scene. All references must outlive it.
  EdgeSprings(const ContactSetting& setting, ContactIndex contact, const contact::EdgeScene& scene,
              const std::vector<contact::SurfaceEdge>& edges);
  /// The step used by SOFT = 1 and 2.
  void set_timestep(double timestep) { timestep_ = timestep; }
  /// `tracked`, `other`: positions in the list of edges.
  [[nodiscard]] LinkSpring between(std::uint32_t tracked, std::uint32_t other) const;

 private:
  /// What an edge contributes to all of its springs.
  struct Edge {
    double stiffness = 0;     ///< SOFT = 0
    double mass = 0;          ///< of both ends
    double segment_mass = 0;  ///< SOFT = 2
    double scale = 1;         ///< SLSFAC and SFS or SFM
    PartIndex part = none<PartIndex>;
  };
  const contact::PairScene& scene_;
  const std::vector<contact::SurfaceEdge>& edges_;
  contact::Friction friction_;
  std::vector<Edge> of_edge_;
  std::int64_t penopt_;
  double timestep_ = 0;
};

}  // namespace gapcheck::solver
