#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/text/file_header.hpp"

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

/// All contacts at one time.
struct InterfaceStates {
  double time = 0;
  std::uint64_t cycle = 0;  ///< from 1; 0: not in the file
  std::vector<InterfaceState> contacts;
};

/// What a file says over the whole run.
struct InterfaceHistory {
  std::vector<LegendEntry> titles;
  std::vector<std::int64_t> single_surface;  ///< contacts without resultants, ascending
  std::vector<InterfaceStates> states;       ///< in order of the file
};

/// Force of a contact on one node of a side.
struct NodeForce {
  std::int64_t node = 0;
  std::size_t side = 0;  ///< 0: A, 1: B
  Vector force = Vector::Zero(), position = Vector::Zero();
  double pressure = 0;  ///< normal force over the node's share of the area
};

/// Titles of contacts in the legend of all three.
[[nodiscard]] std::string contact_header(const FileHeader& header, std::vector<LegendEntry> contacts);

[[nodiscard]] std::string rcforc_text(double time, std::span<const InterfaceState> contacts);
[[nodiscard]] std::string sleout_text(double time, std::uint64_t cycle, std::span<const InterfaceState> contacts);
/// The same in pieces of some hundred kilobytes: the rows of thousands of contacts are never all in memory. Ends with
/// false where `write` does.
[[nodiscard]] bool write_sleout(double time, std::uint64_t cycle, std::span<const InterfaceState> contacts,
                                const std::function<bool(std::string_view)>& write);

/// The states of rcforc (forces, moments) and sleout (energies, friction) files, old and new words. A state is
/// everything with the same time that names no side twice. Rows that cannot be read, and a last state with fewer rows
/// than the one before it, are left out; `diagnostics` say so. NaN printed by the run stays NaN.
[[nodiscard]] InterfaceHistory read_rcforc(std::string_view text, const std::string& name, Diagnostics& diagnostics);
[[nodiscard]] InterfaceHistory read_sleout(std::string_view text, const std::string& name, Diagnostics& diagnostics);

/// The nodes of one contact, a block for each side that has some. No solver file with such data is public; the layout
/// is that of the solver developer's own converter from binout to text (l2a): two lines for each node.
[[nodiscard]] std::string ncforc_text(double time, std::int64_t contact, std::span<const NodeForce> nodes);

}  // namespace gapcheck::results
