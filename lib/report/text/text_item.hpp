#pragma once
#include <cstddef>
#include <string>

#include "report/item/item.hpp"

namespace gapcheck::report {

/// A complete finding in one line, for lists that mix rules and contacts.
[[nodiscard]] std::string line_of(const Item& item, std::size_t indent);

}  // namespace gapcheck::report
