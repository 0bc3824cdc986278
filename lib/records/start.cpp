#include "records/start.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gapcheck {

std::string_view name(StartCause cause) {
  switch (cause) {
    case StartCause::shot:
      return "shot";
    case StartCause::tied:
      return "tied";
    case StartCause::first_cycle:
      return "first-cycle";
  }
  return "";
}

std::string score(const StartContact& contact) {
  if (!contact.not_known.empty()) return "not known: " + contact.not_known;
  std::string text;
  const auto add = [&](const std::string& clause) { text += (text.empty() ? "" : "; ") + clause; };
  if (contact.released > 0) add(fmt::format("loses {} node{}", contact.released, contact.released == 1 ? "" : "s"));
  if (contact.forced > 0)
    add(contact.no_energy.empty() ? fmt::format("starts with an energy of {:.6g} from nothing", contact.energy)
                                  : "starts with an energy from nothing that is not known");
  if (contact.moved > 0) add(fmt::format("starts moved by at most {:.6g}", contact.largest_move));
  if (contact.kept > 0)
    add(contact.least_share ? fmt::format("starts with {:.4g} % of its thickness", 100 * *contact.least_share)
                            : fmt::format("forgives at most {:.6g}", contact.deepest_kept));
  return text.empty() ? "starts clean" : text;
}

bool starts_clean(const StartReport& report) {
  return report.crossings.empty() && report.shapes.collapsed == 0 &&
         std::all_of(report.contacts.begin(), report.contacts.end(),
                     [](const StartContact& contact) { return contact.clean(); });
}

}  // namespace gapcheck
