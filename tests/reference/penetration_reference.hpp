#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "records/penetration.hpp"
#include "records/tie_failure.hpp"
#include "reference/scene.hpp"

namespace gapcheck::reference {

/// What the rules say of one node in one contact.
struct Record {
  std::int64_t contact = 0, node = 0;
  PenetrationKind kind = PenetrationKind::initial;
  Outcome outcome = Outcome::reported;
  double depth = 0, contact_distance = 0;
  /// Elements of the segments that are equally near, in the order of the surface: the first one counts.
  std::vector<std::int64_t> elements;
};

/// A node whose verdict depends on the last digits: near a limit, or two segments equally near. Node 0: all of the
/// contact.
struct Doubt {
  std::int64_t contact = 0, node = 0;
  std::string why;
};

/// What the rules say of a tied contact: the nodes that are reported, and how many tie.
struct TieRecord {
  std::int64_t contact = 0, node = 0;
  TieReason reason = TieReason::sep;
  double distance = 0;  ///< of nodes that tie
};
struct TieCounts {
  std::int64_t contact = 0;
  std::uint64_t ties = 0, untied = 0, out_of_reach = 0;
};

struct Findings {
  std::vector<TieRecord> tie_records;
  std::vector<TieCounts> tie_counts;
  std::vector<Record> records;  ///< by contact in deck order
  std::vector<Doubt> doubts;
  /// Contacts that were judged; after a doubt that may change coordinates the later ones are not.
  std::vector<std::int64_t> judged;
};

/// The penetration search from the written rules, in the plainest way: every node against every segment. Takes time in
/// proportion to nodes x segments.
[[nodiscard]] Findings find_penetrations(const Scene& scene);

}  // namespace gapcheck::reference
