#pragma once
#include <string>
#include <string_view>

#include "report/write/writers.hpp"

namespace gapcheck::report {

/// A page with a line for each deck of one call, gravest first: its verdict, its findings by severity, the worst of
/// them, and a link to its own page (Report::page) where there is one. `path`: of the index itself, from which the
/// links lead. It loads nothing and has no scripts; text of decks is escaped. Deterministic.
[[nodiscard]] std::string html_index(const Reports& reports, const std::string& path, std::string_view version);

}  // namespace gapcheck::report
