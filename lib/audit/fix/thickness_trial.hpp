#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "audit/shared/free_thickness.hpp"
#include "contact/initial.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// Thinner sections of two parts.
struct ThinnerSections {
  std::map<std::int64_t, double> thickness;  ///< T1 … T4 by section id
  std::size_t other_parts = 0;               ///< that have one of these sections, too
};

/// What a thickness of both sides adds to the contact distance of a record: a half from each that is not a solid.
[[nodiscard]] double share_of_thickness(const model::Model& model, const Penetration& p);

/// The largest share of the contact distance that a thickness of both sides takes from the records.
[[nodiscard]] double given_away(const model::Model& model, std::span<const Penetration> records, double thickness);

/// Tries other thicknesses on a model, searches the contact with them, and restores them. The model must outlive it.
class ThicknessTrial {
 public:
  explicit ThicknessTrial(model::Model& model) : model_(model), present_(model) {}

  /// SST = MST of the contacts without thicknesses that it does not replace.
  [[nodiscard]] std::vector<FreeCard> cards(std::span<const ContactIndex> contacts, const contact::InitialState& state);

  /// The largest OPTT, four digits, with which nothing penetrates between two parts (ids) in a contact, and
  /// no more nodes than now elsewhere in it; 0: none, or not found in two searches. `records`: of the pair, `all`: of
  /// the contact.
  [[nodiscard]] double free_optt(ContactIndex contact, std::int64_t a, std::int64_t b,
                                 std::span<const Penetration> records, std::span<const Penetration> all);

  /// The thickness of the parts' sections that gives them a contact thickness; nothing if anything other than one
  /// uniform thickness for each part's shells decides, or if a section would become thicker.
  [[nodiscard]] std::optional<ThinnerSections> sections(ContactIndex contact, std::int64_t a, std::int64_t b,
                                                        std::span<const Penetration> records, double thickness) const;

 private:
  [[nodiscard]] contact::InitialState search(std::vector<contact::ThicknessChange> changes,
                                             const std::vector<ContactIndex>& chosen);
  [[nodiscard]] std::optional<double> section_thickness(ContactIndex contact, PartIndex part, double thickness) const;

  model::Model& model_;
  contact::SurfaceStore present_;
};

}  // namespace gapcheck::audit
