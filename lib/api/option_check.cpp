#include "api/option_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "audit/registry.hpp"

namespace gapcheck::api {

void OptionCheck::amount(std::string_view option, std::optional<double> value) {
  if (value && !(std::isfinite(*value) && *value >= 0))
    fault(fmt::format("{}: {} is not a number of 0 or more", option, *value));
}

void OptionCheck::rules(std::string_view option, const std::vector<std::string>& patterns, bool of_runs) {
  const auto all = audit::rules();
  for (const std::string& pattern : patterns)
    if (std::none_of(all.begin(), all.end(), [&](const auto& rule) {
          return rule.of_runs() == of_runs && audit::selected(rule, {pattern}, {});
        }))
      fault(fmt::format("{}: '{}' is not a rule on {}", option, pattern, of_runs ? "runs" : "decks"));
}

void OptionCheck::contacts(const std::vector<std::int64_t>& ids, const std::vector<const gapcheck::Report*>& reports,
                           std::string_view why) {
  const auto has = [](const gapcheck::Report& report, std::int64_t id) {
    return std::any_of(report.contacts.begin(), report.contacts.end(),
                       [id](const ContactSummary& contact) { return contact.id == id; });
  };
  for (const std::int64_t id : ids)
    if (std::none_of(reports.begin(), reports.end(), [&](const gapcheck::Report* report) { return has(*report, id); }))
      fault(fmt::format("contact {}: {}", id, why));
}

void OptionCheck::parts(const std::vector<std::int64_t>& unknown) {
  for (const std::int64_t id : unknown) fault(fmt::format("part {}: the deck has no such part", id));
}

void OptionCheck::fault(std::string message) {
  if (message_.empty()) message_ = std::move(message);
}

}  // namespace gapcheck::api
