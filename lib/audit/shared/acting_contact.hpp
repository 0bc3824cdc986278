#pragma once
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// Which contact keeps the solids of two parts apart; builds the surfaces of contacts when it is first asked.
class ActingContact {
 public:
  using Surfaces = std::function<const contact::ContactSurfaces&(ContactIndex)>;
  /// `contacts`: those that count, in order. The model must outlive it.
  ActingContact(const model::Model& model, std::vector<ContactIndex> contacts, Surfaces surfaces)
      : model_(model), contacts_(std::move(contacts)), surfaces_(std::move(surfaces)) {}
  /// The first one with solid faces of one part on one side and of the other part on the other; none<ContactIndex> if
  /// there is none, or where the deck excludes the pair.
  [[nodiscard]] ContactIndex operator()(PartIndex p, PartIndex q);

 private:
  /// Parts with solid faces on the two sides of a contact, as masks over Model::parts.
  struct SolidParts {
    std::vector<bool> a, b;
  };
  [[nodiscard]] const SolidParts& solids(ContactIndex contact);

  const model::Model& model_;
  std::vector<ContactIndex> contacts_;
  Surfaces surfaces_;
  std::map<ContactIndex, SolidParts> parts_;
};

}  // namespace gapcheck::audit
