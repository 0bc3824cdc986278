#include "audit/rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::rule::tie_moved {

const Rule definition{record_rules::tie_moved};

}  // namespace gapcheck::audit::rule::tie_moved
