#pragma once
#include <cstdint>
#include <vector>

#include "contact/edge/edge_pairs.hpp"
#include "contact/pair/pair.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/surface/neighbours.hpp"

namespace gapcheck::contact {

/// True for contacts that check edges against edges: types 26, and SOFT = 2 with a DEPTH that ends in 5. Source:
/// contact rules, section 1.5.
[[nodiscard]] bool looks_at_edges(const model::Contact& contact, const ContactType& type);

/// The edges of one contact, with the data that the scene of their pairs refers to. Both sides of a two-sided contact
/// are one surface, SURFA's segments first. All references must outlive it.
class EdgeScene {
 public:
  /// `x`: coordinates by node, read whenever a pair is decided. `whole_solids`: as in Neighbours.
  EdgeScene(const model::Model& model, ContactIndex contact, const ContactSurfaces& surfaces,
            const std::vector<Vector>& x, bool whole_solids);
  EdgeScene(const EdgeScene&) = delete;
  EdgeScene& operator=(const EdgeScene&) = delete;

  [[nodiscard]] const PairScene& scene() const { return scene_; }
  [[nodiscard]] PairScene& scene() { return scene_; }
  /// Free edges of shells (type i26: all), beam axes in types 26.
  [[nodiscard]] std::vector<SurfaceEdge> edges() const;
  [[nodiscard]] bool on_b(const SurfaceEdge& edge) const { return edge.segment.value >= of_a_; }
  /// False for two edges of the same side of a two-sided contact.
  [[nodiscard]] bool opposite(const SurfaceEdge& e, const SurfaceEdge& f) const {
    return !two_sided_ || on_b(e) != on_b(f);
  }

 private:
  std::size_t of_a_;
  bool two_sided_;
  Segments both_;  ///< of two-sided contacts
  const Segments& segments_;
  Neighbours neighbours_;
  PairScene scene_;
};

/// The free shell edges of SURFA as a single surface of lines, with their ends as tracked nodes: what type 22 keeps
/// apart. Half thicknesses stay below a fifth of the shell's shortest edge, as in single surfaces, unless SSTHK = 1.
[[nodiscard]] ContactSurfaces free_edge_surface(const model::Model& model, ContactIndex contact,
                                                const ContactSurfaces& surfaces, const std::vector<Vector>& x);

}  // namespace gapcheck::contact
