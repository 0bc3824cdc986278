#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "results/file_header.hpp"

namespace gapcheck::results {

// Three files of one kind: rcforc (forces on the sides of contacts), sleout (their energies), ncforc (forces on their
// nodes). Side A: surfa, formerly slave; side B: surfb, formerly master.

/// One contact at one time.
struct InterfaceState {
  std::int64_t contact = 0;
  bool single_surface = false;  ///< its resultants are undefined
  std::array<Vector, 2> force{Vector::Zero(), Vector::Zero()};
  std::array<Vector, 2> moment{Vector::Zero(), Vector::Zero()};
  std::array<double, 2> energy{};
  double friction = 0;  ///< of the energies: dissipated by friction
};

/// Force of a contact on one node.
struct NodeForce {
  std::int64_t node = 0;
  Vector force = Vector::Zero(), position = Vector::Zero();
  double pressure = 0;
};

/// Titles of contacts in the legend of all three.
[[nodiscard]] std::string contact_header(const FileHeader& header, std::vector<LegendEntry> contacts);

[[nodiscard]] std::string rcforc_text(double time, std::span<const InterfaceState> contacts);
[[nodiscard]] std::string sleout_text(double time, std::uint64_t cycle, std::span<const InterfaceState> contacts);

/// Nodes of one contact. No file of the solver with such data is public; this layout is our own: a heading
/// with contact and time, then per node id, force, pressure and position, (i10, 7e13.5).
[[nodiscard]] std::string ncforc_text(double time, std::int64_t contact, std::span<const NodeForce> nodes);

}  // namespace gapcheck::results
