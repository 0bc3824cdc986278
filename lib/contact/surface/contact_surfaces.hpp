#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "contact/definition/contact_type.hpp"
#include "contact/surface/surface.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// One side of a contact with its thickness.
struct ContactSide {
  Selection selection;
  TrackedNodes nodes;       ///< of side B only in contacts that look for side B's nodes
  bool nodes_only = false;  ///< it names nodes and no elements
  /// `selection.segments` ends with this many beam axes; only single-surface contacts keep any.
  std::size_t lines = 0;
};

/// Both sides of a contact, as input for the search. Single-surface contacts have only side A.
struct ContactSurfaces {
  ContactType type;
  ContactSettings settings;
  ContactSide a, b;
  [[nodiscard]] bool two_sided() const { return type.treatment != Treatment::single_surface; }
};

/// Builds the surfaces of one contact on the coordinates given. Tied contacts use the true thickness, whatever SHLTHK
/// says, and |SST| and |MST| if these are negative; `change` does not apply to them. `index`: of this model.
[[nodiscard]] ContactSurfaces build_surfaces(const model::Model& model, const model::Contact& contact,
                                             const std::vector<Vector>& x, MeshIndex& index,
                                             const ThicknessChange& change = {});

struct GoneElements;

/// The surfaces of a model's contacts on the deck's own coordinates, each built on first use and kept. Not for use from
/// several threads. The model must outlive it. `changes`: of thickness, by contact; empty: none.
class SurfaceStore {
 public:
  explicit SurfaceStore(const model::Model& model, std::vector<ThicknessChange> changes = {})
      : model_(model), index_(model), changes_(std::move(changes)), built_(model.contacts.size()) {}
  [[nodiscard]] const ContactSurfaces& at(ContactIndex contact);
  /// The same on other coordinates; not kept.
  [[nodiscard]] ContactSurfaces build(ContactIndex contact, const std::vector<Vector>& x);
  /// For a contact that is not in the model, without any change of thickness.
  [[nodiscard]] ContactSurfaces build(const model::Contact& contact, const std::vector<Vector>& x) {
    return build_surfaces(model_, contact, x, index_);
  }
  /// What is left of a contact's surfaces once elements have failed (contact/erosion.hpp). `x`: present coordinates.
  [[nodiscard]] ContactSurfaces erode(ContactIndex contact, const ContactSurfaces& now, const GoneElements& gone,
                                      const std::vector<Vector>& x);
  [[nodiscard]] std::uint64_t built() const { return count_; }
  /// How often surfaces were requested, including those already built.
  [[nodiscard]] std::uint64_t asked() const { return asked_; }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  const model::Model& model_;
  MeshIndex index_;
  std::vector<ThicknessChange> changes_;
  std::vector<std::unique_ptr<const ContactSurfaces>> built_;
  std::uint64_t count_ = 0, asked_ = 0;
  double seconds_ = 0;
};

}  // namespace gapcheck::contact
