#include "audit/rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::rule::segment_penetration {

const Rule definition{record_rules::segment_penetration};

}  // namespace gapcheck::audit::rule::segment_penetration
