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
  /// `selection.segments` ends in this many beam axes; only single-surface contacts keep any.
  std::size_t lines = 0;
};

/// Both sides of a contact as the search takes them. Single-surface contacts have side A only.
struct ContactSurfaces {
  ContactType type;
  ContactSettings settings;
  ContactSide a, b;
  [[nodiscard]] bool two_sided() const { return type.treatment != Treatment::single_surface; }
};

/// Builds the surfaces of one contact on the coordinates given. Tied contacts measure with the true thickness, whatever
/// SHLTHK says, and with |SST| and |MST| where these are negative; `change` is not for them. `index`: of this model.
[[nodiscard]] ContactSurfaces build_surfaces(const model::Model& model, const model::Contact& contact,
                                             const std::vector<Vector>& x, MeshIndex& index,
                                             const ThicknessChange& change = {});

struct GoneElements;

/// The surfaces of a model's contacts on the deck's own coordinates, each built when it is first asked for and kept.
/// Not for use from several threads. The model must outlive it. `changes`: of thickness, by contact; empty: none.
class SurfaceStore {
 public:
  explicit SurfaceStore(const model::Model& model, std::vector<ThicknessChange> changes = {})
      : model_(model), index_(model), changes_(std::move(changes)), built_(model.contacts.size()) {}
  /// `contact`: position in Model::contacts.
  [[nodiscard]] const ContactSurfaces& at(std::uint32_t contact);
  /// The same on other coordinates; not kept.
  [[nodiscard]] ContactSurfaces build(std::uint32_t contact, const std::vector<Vector>& x);
  /// Of a contact that is not in the model, without any change of thickness.
  [[nodiscard]] ContactSurfaces build(const model::Contact& contact, const std::vector<Vector>& x) {
    return build_surfaces(model_, contact, x, index_);
  }
  /// What is left of a contact's surfaces once elements have failed (contact/erosion.hpp). `x`: present coordinates.
  [[nodiscard]] ContactSurfaces erode(std::uint32_t contact, const ContactSurfaces& now, const GoneElements& gone,
                                      const std::vector<Vector>& x);
  [[nodiscard]] std::uint64_t built() const { return count_; }
  /// How often surfaces were asked for, those that stood ready included.
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
