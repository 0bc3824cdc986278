#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/interface/contact_state.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// A point of a contact surface: nodes and their weights, which sum to 1. Weight 0: unused entry.
struct ContactPoint {
  std::array<NodeIndex, 4> nodes{};
  std::array<double, 4> weights{};
  /// The sum of something by node at this point.
  [[nodiscard]] Vector of(const std::vector<Vector>& by_node) const {
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < 4; ++i)
      if (weights[i] != 0) sum += weights[i] * by_node[nodes[i].value];
    return sum;
  }
};

/// One force of a contact: on a point of one side, and the opposite one on a point of the other.
struct ContactLink {
  ContactPoint tracked, reference;
  bool exchanged = false;         ///< the tracked point is on side B
  Vector force = Vector::Zero();  ///< on the tracked point
};

/// A single event of a contact, for the message file: a tie that fails.
struct ContactEvent {
  ContactIndex contact;  ///< position in Model::contacts
  double time = 0;
  std::string text;  ///< lines of a message block, without its heading
};

/// The interface of code that calculates contacts, for code that reports them or measures their forces.
class ContactSource {
 public:
  virtual ~ContactSource() = default;
  /// One for each contact that it calculates, in deck order. Complete after the first force evaluation.
  [[nodiscard]] virtual std::span<const ContactState> states() const = 0;
  /// The nodes that one of them (position among the states) affects.
  [[nodiscard]] virtual std::vector<ContactNode> nodes(std::size_t position) const = 0;
  /// Adds its forces at the time of the last force evaluation.
  virtual void links(std::size_t position, std::vector<ContactLink>& links) const = 0;
  /// The energy that one of them stores in its springs; nothing: it cannot be told from the state.
  [[nodiscard]] virtual std::optional<double> stored(std::size_t /*position*/) const { return std::nullopt; }
  /// Events since the last call.
  [[nodiscard]] virtual std::vector<ContactEvent> take_events() { return {}; }
};

/// One contact of a source.
struct ContactView {
  const ContactSource* source = nullptr;
  std::size_t position = 0;
  [[nodiscard]] const ContactState& state() const { return source->states()[position]; }
  [[nodiscard]] std::vector<ContactNode> nodes() const { return source->nodes(position); }
  [[nodiscard]] std::optional<double> stored() const { return source->stored(position); }
};

}  // namespace gapcheck::solver
