#include "audit/rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::rule::edge_penetration {

const Rule definition{record_rules::edge_penetration};

}  // namespace gapcheck::audit::rule::edge_penetration
