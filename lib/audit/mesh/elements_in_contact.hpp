#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// What contacts say about the elements of one kind, beside them.
struct InContact {
  std::vector<std::int64_t> contact;  ///< id of the first one with the element in a surface; 0: none
  std::vector<double> thickness;      ///< the largest of all contacts; 0: none
};

/// The same for all kinds, from contacts whose cards were read; their surfaces are built where they are not there yet.
class ElementsInContact {
 public:
  ElementsInContact(const model::Model& model, contact::SurfaceStore& surfaces, std::span<const ContactIndex> contacts);
  [[nodiscard]] const InContact& of(model::ElementKind kind) const { return kinds_[static_cast<std::size_t>(kind)]; }

 private:
  void add(const contact::Segments& segments, std::int64_t contact);

  std::array<InContact, 7> kinds_;  ///< by ElementKind
};

}  // namespace gapcheck::audit
