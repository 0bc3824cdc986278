#pragma once
#include <cstdint>

#include "contact/definition/contact_type.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// What a contact remembers about one tracked node from cycle to cycle.
struct NodeContact {
  enum class State : std::uint8_t {
    apart,     ///< outside: the next penetration is its first
    touching,  ///< found before: penetration gives force
    released,  ///< was too deep: no force until it has left the whole contact zone
  } state = State::apart;
  double forgiven = 0;  ///< IGNORE: penetration without force
};

/// The position of a tracked node relative to the segments of its contact in one cycle.
struct NodeEncounter {
  bool penetrates = false;  ///< it is in a segment's band and penetrates it
  bool in_zone = false;     ///< it is nearer to some segment than the contact distance, in its band or not
  double penetration = 0;
  double release_depth = 0;  ///< beyond it the node is released
  bool movable = true;       ///< shooting-node logic may move it; nodes of rigid bodies are not free to be moved
  bool followed = false;     ///< the segment had it in sight in the cycle before: see was_followed()
};

enum class NodeAction : std::uint8_t {
  none,
  force,  ///< by penetration - NodeContact::forgiven
  move,   ///< to the free side of the contact surface, by `shooting_move` penetrations
};

/// What happens to a tracked node in a cycle, and what is remembered. A node that was followed up to the surface is in
/// ordinary contact: forced from its first penetration on. One that is found suddenly, at the start or later, is moved
/// with IGNORE = 0 (SNLOG = 1: forced), and with IGNORE = 1 or 2 its depth is forgiven; the forgiven depth only
/// decreases with the penetration, and the thickness is full again once the node has left. A node that cannot be moved
/// gets its force at once. Source: contact rules, sections 5 and 7.
[[nodiscard]] NodeAction advance(NodeContact& node, const ContactSettings& settings, const NodeEncounter& encounter);

/// The same for INTERFERENCE contacts, whose overlap is meant: every penetration gives force at once, nothing is moved
/// or forgiven. Source: LS-DYNA Keyword User's Manual, Vol. I, *CONTACT, INTERFERENCE, as commonly quoted.
[[nodiscard]] NodeAction advance_interference(NodeContact& node, const NodeEncounter& encounter);

/// The same for SOFT = 2: the depth of a node that is found suddenly is the force-free baseline. It only decreases with
/// the penetration and loses the share `reduction` in every cycle. Nothing is moved or released. Source: contact rules,
/// section 7.4.
[[nodiscard]] NodeAction advance_from_baseline(NodeContact& node, const NodeEncounter& encounter, double reduction);

/// Whether a pair that penetrates now was in sight in the cycle before: apart, by a gap less than `zone`. `distance`:
/// in that cycle, negative behind; `contact_distance`: from which on there is none; `tolerance`: of these lengths.
/// Nodes, edges and the corners of segments are all asked this way. Source: contact rules, section 7.
[[nodiscard]] inline bool was_followed(double distance, double contact_distance, double zone, double tolerance) {
  return distance >= contact_distance - tolerance && distance < contact_distance + zone;
}

/// DPRFAC at a time: the share of the baseline lost in each cycle, 0 to 1. Negative: number of a curve over time.
/// Source: contact rules, section 7.4.
[[nodiscard]] double baseline_reduction(const model::Model& model, const model::Contact& contact, double time);

}  // namespace gapcheck::contact
