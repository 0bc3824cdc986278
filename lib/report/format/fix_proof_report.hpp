#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "records/fix_proof.hpp"

namespace gapcheck::report {

/// A table of what a run of a deck does before and after a correction; rows without anything are left out.
void append_proof(const FixProof& proof, std::string& out);

/// "; proven by a run": for the end of a line.
[[nodiscard]] std::string_view verdict(const FixProof& proof);

/// Its part of a JSON report.
[[nodiscard]] nlohmann::ordered_json proof_json(const FixProof& proof);

}  // namespace gapcheck::report
