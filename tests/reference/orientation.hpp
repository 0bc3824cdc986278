#pragma once
#include <map>

#include "reference/surfaces.hpp"

namespace gapcheck::reference {

/// Which way the shells of a part face: 1 as numbered, -1 turned.
using Turns = std::map<std::int64_t, int>;

/// Turns each part of an oriented surface toward the tracked nodes (contact rules, section 1.4).
[[nodiscard]] Turns turned_parts(const Rules& rules, const Side& tracked, const Side& reference, const Positions& x);

/// True if the rules say that the surface is turned.
[[nodiscard]] bool turns(const Rules& rules, const Side& reference);

}  // namespace gapcheck::reference
