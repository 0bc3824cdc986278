#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "report/html/html.hpp"
#include "report/item/item.hpp"

namespace gapcheck::report {

/// What the page of html() shows, as JSON without any '<', so that it can be in a script element. Arrays of numbers for
/// the picture are little-endian and in base64.
[[nodiscard]] std::string html_data(const Report& report, const NodePosition& position, const HtmlOptions& options);

// Parts of the above, for tests.

/// A finding with the data that the picture needs.
struct HtmlFinding {
  Item item;
  std::vector<std::int64_t> segment;  ///< node ids; empty: none
  std::size_t number = 0;             ///< from 1, in the order of --format csv; those left out on purpose follow
  std::optional<Vector> position;     ///< where it is drawn
  std::optional<Vector> vector;       ///< from there to the contact surface
};

/// The first `options.group` findings of each rule in each contact, then the most severe and deepest, at most
/// `options.findings`; in the report's order, those left out on purpose last.
[[nodiscard]] std::vector<HtmlFinding> html_findings(const Report& report, const NodePosition& position,
                                                     const HtmlOptions& options);

}  // namespace gapcheck::report
