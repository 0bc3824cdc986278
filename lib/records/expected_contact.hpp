#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck {

/// The reason where a node passes all of its contact in one step.
inline constexpr std::string_view crossing_reason = "a node comes too close in one step";

/// What the nodes of one part do to the segments of another one in a contact, if all go on along straight lines.
/// Quantities are in the deck's units.
struct ExpectedContact {
  std::uint32_t contact = 0;              ///< position in StartReport::contacts
  std::int64_t part = 0, other_part = 0;  ///< ids: of the nodes, of the segments; 0: not known
  std::uint64_t nodes = 0;                ///< that meet a segment
  std::int64_t node = 0;                  ///< the first of them
  double time = 0;                        ///< when it does
  double speed = 0;                       ///< greatest speed of approach, along the normal
  /// The largest share of 0.8 of the contact distance that a node comes closer in one step, and how many nodes come
  /// closer by all of it; nothing: without contact distance.
  std::optional<double> in_step;
  std::uint64_t crossing = 0;
  /// Depth at which the first node is released, over the depth that it reaches in the run if nothing but this
  /// contact acts on the two; nothing: not known.
  std::optional<double> margin;
  /// The same with v sqrt(m / k) of each node alone, where parts deform: not what the run does.
  std::optional<double> alone;
  /// Between which the margin of the run lies; nothing: no bound is known.
  std::optional<double> low, high;
  std::string reason;           ///< why the margin is not known; empty: it is
  bool never_released = false;  ///< the contact releases no node, however deep
  /// What would make the margin 2, or that of the nodes alone, each by itself: contact thickness (SST, MST), SOFSCL
  /// with SOFT = 1, step of the run.
  std::optional<double> thickness, sofscl, step;
  std::string_view thickness_card;  ///< "SST" or "MST"
  /// The contact lets go for sure; it does not for sure.
  [[nodiscard]] bool lost() const { return high && *high < 1; }
  [[nodiscard]] bool held() const { return low && *low > 1; }
};

/// Nodes of a part that reach a rigid wall along straight lines.
struct ExpectedWall {
  std::int64_t wall = 0, part = 0;  ///< id; 0: no part
  std::uint64_t nodes = 0;
  std::int64_t node = 0;  ///< the first of them
  double time = 0, speed = 0;
};

/// What will meet, if all goes on along straight lines, and where contact will not hold it.
struct ExpectedContacts {
  double until = 0;                        ///< as far as the search has looked
  double end = 0;                          ///< of the run
  double step = 0;                         ///< of its first cycle
  std::vector<ExpectedContact> contacts;   ///< the least margin first
  std::vector<ExpectedWall> walls;         ///< by time
  std::vector<std::string> not_looked_at;  ///< what could meet and is not looked at
  std::uint64_t still = 0;                 ///< pairs of groups of nodes and segments with one motion
  std::uint64_t candidates = 0;            ///< pairs of a node and a segment whose swept boxes meet
  std::uint64_t closest_points = 0;        ///< that their times of contact took
};

}  // namespace gapcheck
