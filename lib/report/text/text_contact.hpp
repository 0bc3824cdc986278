#pragma once
#include <string>

#include "records/report.hpp"
#include "report/item/sums.hpp"
#include "report/text/paint.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {

/// "703 tracked nodes, 648 segments: 48 penetrations, 20 released nodes, deepest 1.5 at node 683"; for ties what became
/// of the nodes; for a contact that was not judged, why.
[[nodiscard]] std::string contact_result(const Report& report, std::uint32_t position, const Sums& sum,
                                         const Paint& paint);

/// Everything about one contact: result, time steps, tables of the deepest nodes and of ties. Returns the sums of its
/// records.
Sums append_contact_block(const Report& report, std::uint32_t position, const TextOptions& options, const Paint& paint,
                          std::string& out);

}  // namespace gapcheck::report
