#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "solver/interface/contact_spring.hpp"

namespace gapcheck::solver {

/// One face of a mortar surface: a segment, or the flat face at a free edge of a shell, as wide as the shell is thick.
struct MortarFace {
  model::SegmentNodes nodes;        ///< that carry the forces at its corners; at a free edge each of the two twice
  model::SegmentNodes shell;        ///< at a free edge: the segment that ends there
  std::vector<NodeIndex> elements;  ///< all nodes of its element, ascending: faces that share one never meet
  PartIndex part = none<PartIndex>;
  bool on_b = false;      ///< of SURFB
  bool rim = false;       ///< at a free edge of a shell
  bool oriented = false;  ///< it has a front: faces of solids and free edges, shells of forming tools
  double half = 0;        ///< half the contact thickness; 0: the face itself is in contact
  double thickness = 0;   ///< of the shell in contact, for free edges
  double reach = 0;       ///< its share of the depth at which a pair is released
  double slope = 0;       ///< α K / d_c: pressure over penetration; 0: not known
  double length = 0;      ///< d_c: thickness of a shell, V / A of a solid or PENMAX
  double mass = 0;        ///< per area
  double shift = 0;       ///< of the mid-surface along the shell's normal
};

/// The faces of one mortar contact, SURFA's first; beam axes are left out. Single surfaces have only SURFA's.
class MortarSurface {
 public:
  /// `surfaces` must be on the coordinates `x`.
  MortarSurface(const model::Model& model, const ContactMasses& masses, const model::Contact& contact,
                const contact::ContactSurfaces& surfaces, const std::vector<Vector>& x);
  [[nodiscard]] std::size_t size() const { return faces_.size(); }
  [[nodiscard]] const MortarFace& operator[](std::uint32_t face) const { return faces_[face]; }
  /// From the nodes of a face to its corners: at a free edge half the thickness along the shell's normal, and the
  /// offset of the mid-surface.
  [[nodiscard]] static std::array<Vector, 4> offsets(const MortarFace& face, const std::vector<Vector>& x);
  /// The corners of a face.
  [[nodiscard]] static std::array<Vector, 4> corners(const MortarFace& face, const std::vector<Vector>& x);

 private:
  struct Side;
  void add_side(const Side& side);
  [[nodiscard]] MortarFace segment_face(const Side& side, std::size_t segment) const;
  void add_rims(const Side& side, const MortarFace& face, SegmentIndex segment, const contact::Neighbours& around);

  const model::Model& model_;
  const ContactMasses& masses_;
  const model::Contact& contact_;
  const std::vector<Vector>& x_;
  std::vector<MortarFace> faces_;
};

/// Whether two faces have a node, or elements with a node, in common.
[[nodiscard]] bool are_joined(const MortarFace& a, const MortarFace& b);

}  // namespace gapcheck::solver
