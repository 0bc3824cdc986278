#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "audit/rule.hpp"
#include "contact/tie/ties.hpp"

namespace gapcheck::audit {

/// Calls visit(contact, nodes) for every tied contact that --contact lets through and
/// judged any nodes, in deck order. Nodes of parts that --part leaves out are not in the span, which is valid only
/// during the call. Decks without tied contacts cost nothing; otherwise the contacts are initialised.
void for_each_tied_contact(Context& context,
                           const std::function<void(ContactIndex, std::span<const contact::JudgedNode>)>& visit);

/// Nodes of a tied contact that are too far away, with the reason TieReason::too_far.
struct FarNodes {
  std::uint64_t count = 0;
  const contact::JudgedNode* farthest = nullptr;  ///< equally far ones: that with the smallest id
  double reach = 0;                               ///< |SST|, four digits, that ties them and all that tie now
};

/// Nothing if no node is too far, or no thickness would tie them. `nodes`: of one contact.
[[nodiscard]] std::optional<FarNodes> far_nodes(const model::Model& model, std::span<const contact::JudgedNode> nodes);

/// "11, 12, 13", the first few of the numbers and ", ..." where there are more.
[[nodiscard]] std::string first_few(const std::vector<std::int64_t>& numbers);

/// "1 node", "3 nodes".
[[nodiscard]] std::string node_count(std::uint64_t nodes);

}  // namespace gapcheck::audit
