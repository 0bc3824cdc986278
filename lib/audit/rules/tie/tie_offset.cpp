#include "audit/rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::rule::tie_offset {

const Rule definition{record_rules::tie_offset};

}  // namespace gapcheck::audit::rule::tie_offset
