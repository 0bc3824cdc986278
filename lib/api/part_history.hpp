#pragma once
#include <gapcheck/part_history.hpp>
#include <optional>

#include "results/curves/matsum.hpp"

namespace gapcheck::api {

/// The states of a matsum as arrays; nothing: it has none. A state that is not later than earlier ones replaces them: a
/// restarted run repeats some.
[[nodiscard]] std::optional<PartHistory> part_arrays(const results::PartHistory& history);

}  // namespace gapcheck::api
