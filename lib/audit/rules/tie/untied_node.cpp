#include "audit/rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::rule::untied_node {

const Rule definition{record_rules::untied_node};

}  // namespace gapcheck::audit::rule::untied_node
