#pragma once
#include <cstdint>
#include <vector>

#include "model/model.hpp"
#include "records/penetration.hpp"

namespace gapcheck::reference {

/// What the rules say of one node in one contact.
struct Record {
  std::int64_t contact = 0, node = 0;
  PenetrationKind kind = PenetrationKind::initial;
  Outcome outcome = Outcome::reported;
  double depth = 0, contact_distance = 0;
};

/// A node whose verdict hangs on the last digits: near a limit, or two segments equally near.
struct Doubt {
  std::int64_t contact = 0, node = 0;
};

struct Findings {
  std::vector<Record> records;  ///< by contact in deck order, then node id
  std::vector<Doubt> doubts;
  /// Contacts that were judged; after a doubt that may change coordinates the later ones are not.
  std::vector<std::int64_t> judged;
};

/// The penetration search from the written rules, in the plainest way: every node against every segment. Covers shells
/// and bricks in AUTOMATIC_SINGLE_SURFACE, AUTOMATIC_SURFACE_TO_SURFACE, AUTOMATIC_NODES_TO_SURFACE and
/// AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE given by parts, part sets or everything; other contacts are passed over.
/// Takes time in proportion to nodes x segments.
[[nodiscard]] Findings find_penetrations(const model::Model& model);

}  // namespace gapcheck::reference
