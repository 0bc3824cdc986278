#pragma once
#include "audit/rule.hpp"

namespace gapcheck::audit {

// Every rule, by name; each is defined in the file of its name. The registry lists them once more, in order of ids.
extern const Rule initial_penetration, released_node, edge_zone_penetration;
extern const Rule untied_node;
extern const Rule duplicate_id, unknown_reference, empty_surface;

}  // namespace gapcheck::audit
