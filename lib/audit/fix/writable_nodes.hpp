#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "audit/fix/freedoms.hpp"
#include "audit/fix/node_lines.hpp"

namespace gapcheck::audit {

/// Positions as the lines of a deck can express them, and the nodes whose lines cannot be rewritten.
class WritableNodes {
 public:
  /// `deck`: its coordinates by node. Both must outlive this.
  WritableNodes(NodeLines& lines, const std::vector<Vector>& deck) : lines_(lines), deck_(deck), known_(deck.size()) {}

  /// Holds those of the nodes whose line cannot be rewritten. Each node is asked once; held ones are not.
  void hold_others(std::span<const NodeIndex> nodes, Freedoms& freedoms);
  /// The deck's coordinates, with all nodes that `x` moves where their lines can express it.
  [[nodiscard]] std::vector<Vector> written(const std::vector<Vector>& x);

  /// The first node whose line cannot be rewritten, for one reason, and the number of such nodes.
  struct Unwritable {
    NodeIndex first;
    std::uint64_t count = 0;
  };
  [[nodiscard]] const std::map<std::string, Unwritable>& unwritable() const { return unwritable_; }

 private:
  NodeLines& lines_;
  const std::vector<Vector>& deck_;
  std::vector<std::uint8_t> known_;  ///< by node: whether its line can be rewritten was asked
  std::map<std::string, Unwritable> unwritable_;
};

}  // namespace gapcheck::audit
