#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "records/penetration.hpp"
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

struct Findings {
  std::vector<Record> records;  ///< by contact in deck order
  std::vector<Doubt> doubts;
  /// Contacts that were judged; after a doubt that may change coordinates the later ones are not.
  std::vector<std::int64_t> judged;
};

/// The penetration search from the written rules, in the plainest way: every node against every segment. Takes time in
/// proportion to nodes x segments.
[[nodiscard]] Findings find_penetrations(const Scene& scene);

}  // namespace gapcheck::reference
