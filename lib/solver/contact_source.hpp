#pragma once
#include <span>
#include <vector>

#include "solver/contact_state.hpp"

namespace gapcheck::solver {

/// What result files ask of the contacts of a run, at the time of the last force evaluation.
class ContactSource {
 public:
  virtual ~ContactSource() = default;
  /// One per contact that is calculated, in deck order.
  [[nodiscard]] virtual std::span<const ContactState> states() const = 0;
  /// Nodes in the contact zone of the contact with this position in states(), in a fixed order.
  [[nodiscard]] virtual std::vector<ContactNode> nodes(std::size_t contact) const = 0;
};

}  // namespace gapcheck::solver
