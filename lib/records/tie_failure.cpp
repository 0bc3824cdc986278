#include "records/tie_failure.hpp"

namespace gapcheck {

std::string_view name(TieReason reason) {
  switch (reason) {
    case TieReason::sep:
      return "sep";
    case TieReason::offset:
      return "offset";
    case TieReason::too_far:
      return "far";
    case TieReason::too_short:
      return "short";
    case TieReason::not_found:
      return "notfound";
    case TieReason::rigslav:
      return "rigslav";
    case TieReason::rigmast:
      return "rigmast";
    case TieReason::conflict:
      return "conflict";
  }
  return "?";
}

bool untied(TieReason reason) { return reason != TieReason::sep && reason != TieReason::offset; }

}  // namespace gapcheck
