#include "audit/rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::rule::mortar_penetration {

const Rule definition{record_rules::mortar_penetration};

}  // namespace gapcheck::audit::rule::mortar_penetration
