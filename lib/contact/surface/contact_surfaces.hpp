#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "contact/definition/contact_type.hpp"
#include "contact/surface/contact_side.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// Both sides of a contact, as input for the search. Single-surface contacts have only side A. Contacts with the same
/// side share it; a copy shares both.
struct ContactSurfaces {
  /// `side_a`: not null; `side_b`: null is an empty side.
  ContactSurfaces(ContactType contact_type, const ContactSettings& contact_settings,
                  std::shared_ptr<const ContactSide> side_a, std::shared_ptr<const ContactSide> side_b = nullptr);

  ContactType type;
  ContactSettings settings;
  const ContactSide &a, &b;
  [[nodiscard]] bool two_sided() const { return type.treatment != Treatment::single_surface; }
  /// The same with another side A.
  [[nodiscard]] ContactSurfaces with_a(std::shared_ptr<const ContactSide> side) const {
    return {type, settings, std::move(side), shared_b_};
  }

 private:
  std::shared_ptr<const ContactSide> shared_a_, shared_b_;  ///< hold what a and b refer to
};

/// Builds the surfaces of one contact on the coordinates given. Tied contacts use the true thickness, whatever SHLTHK
/// says, and |SST| and |MST| if these are negative; `change` does not apply to them. `index`: of this model. `sides`:
/// those built before on the same coordinates, which are used again; null: none.
[[nodiscard]] ContactSurfaces build_surfaces(const model::Model& model, const model::Contact& contact,
                                             const std::vector<Vector>& x, MeshIndex& index,
                                             const ThicknessChange& change = {}, SideCache* sides = nullptr);

struct GoneElements;

/// The surfaces of a model's contacts on the deck's own coordinates, each built on first use and kept. Not for use from
/// several threads. The model must outlive it. `changes`: of thickness, by contact; empty: none.
class SurfaceStore {
 public:
  explicit SurfaceStore(const model::Model& model, std::vector<ThicknessChange> changes = {})
      : model_(model), index_(model), changes_(std::move(changes)), built_(model.contacts.size()) {}
  [[nodiscard]] const ContactSurfaces& at(ContactIndex contact);
  /// The same on other coordinates; not kept. `sides`: of other contacts on these coordinates.
  [[nodiscard]] ContactSurfaces build(ContactIndex contact, const std::vector<Vector>& x, SideCache* sides = nullptr);
  /// For a contact that is not in the model, without any change of thickness.
  [[nodiscard]] ContactSurfaces build(const model::Contact& contact, const std::vector<Vector>& x,
                                      SideCache* sides = nullptr) {
    return build_surfaces(model_, contact, x, index_, {}, sides);
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
  SideCache sides_;
  std::vector<std::unique_ptr<const ContactSurfaces>> built_;
  std::uint64_t count_ = 0, asked_ = 0;
  double seconds_ = 0;
};

}  // namespace gapcheck::contact
