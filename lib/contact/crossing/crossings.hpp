#pragma once
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/definition/exclusions.hpp"
#include "contact/search/box_pairs.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "geometry/decide.hpp"

namespace gapcheck::contact {

/// A segment that crosses another, and the element that it belongs to.
struct CrossingSegment {
  model::SegmentNodes nodes{};
  model::ElementKind kind = model::ElementKind::shell;
  std::uint32_t element = no_position;  ///< position in the array of its kind
  PartIndex part = none<PartIndex>;
};

/// Two elements that pass through each other.
struct Crossing {
  ContactIndex contact;  ///< the first that has it
  CrossingSegment a, b;
  Vector from = Vector::Zero(), to = Vector::Zero();  ///< ends of their intersection; equal for a beam's axis
  double depth = 0;  ///< the smaller of the two depths by which they stick out behind each other
  [[nodiscard]] double length() const { return (to - from).stableNorm(); }
};

/// Elements that stick out behind each other by less than this fraction of the larger one's size touch: in real decks,
/// faces meshed to coincide differ by that much.
inline constexpr double crossing_tolerance = 1e-3;

struct CrossingOptions {
  geometry::Mode mode = geometry::Mode::filtered;
  BoxSearch search = BoxSearch::tree;
  double tolerance = crossing_tolerance;   ///< of crossing elements
  const std::vector<Vector>* x = nullptr;  ///< coordinates by node; nullptr: the deck's
};

struct CrossingCounters {
  geometry::DecisionCounters decisions;     ///< of pairs of triangles
  std::atomic<std::uint64_t> box_pairs{0};  ///< pairs of segments whose boxes meet and that share no node
};

/// Parts between which a crossing means nothing: excluded by the deck, one rigid body, spotwelds.
class CrossingPairs {
 public:
  CrossingPairs(const model::Model& model, ContactId contact);
  /// From here on those of another contact.
  void turn_to(const model::Model& model, ContactId contact) { exclusions_ = Exclusions(model, contact); }
  /// False for spotwelds, which are meant to be inside other parts.
  [[nodiscard]] bool takes_part(PartIndex part) const { return part == none<PartIndex> || !spotweld_[part.value]; }
  [[nodiscard]] bool counts(PartIndex a, PartIndex b) const;

 private:
  Exclusions exclusions_;
  std::vector<bool> spotweld_;
  std::vector<std::uint32_t> rigid_body_;  ///< by part; max: deformable
};

/// All pairs of elements of one contact whose mid-surfaces (solids: faces) cross: side A against side B, or a single
/// surface against itself; in types 26 beam axes against segments as well. Quads are two triangles along the diagonal
/// from their first corner. Not counted are segments with a common node, faces of one solid, and CrossingPairs. Once
/// per pair of elements, ascending by them.
[[nodiscard]] std::vector<Crossing> find_crossings(const model::Model& model, ContactIndex contact,
                                                   const ContactSurfaces& surfaces, const CrossingOptions& options,
                                                   CrossingCounters& counters);

/// The same for several contacts (ascending) that keep surfaces apart; a pair in several of them belongs to the first.
[[nodiscard]] std::vector<Crossing> find_crossings(const model::Model& model, std::span<const ContactIndex> contacts,
                                                   SurfaceStore& surfaces, const CrossingOptions& options,
                                                   CrossingCounters& counters);

}  // namespace gapcheck::contact
