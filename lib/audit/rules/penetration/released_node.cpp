#include "audit/rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::rule::released_node {

const Rule definition{record_rules::released_node};

}  // namespace gapcheck::audit::rule::released_node
