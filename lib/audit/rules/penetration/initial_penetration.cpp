#include "audit/rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::rule::initial_penetration {

const Rule definition{record_rules::initial_penetration};

}  // namespace gapcheck::audit::rule::initial_penetration
