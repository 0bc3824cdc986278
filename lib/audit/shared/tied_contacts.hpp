#pragma once
#include <cstdint>
#include <functional>
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

/// "11, 12, 13", the first few of the numbers and ", ..." where there are more.
[[nodiscard]] std::string first_few(const std::vector<std::int64_t>& numbers);

/// "1 node", "3 nodes".
[[nodiscard]] std::string node_count(std::uint64_t nodes);

}  // namespace gapcheck::audit
