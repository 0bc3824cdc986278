#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"

namespace gapcheck::audit::rule::missing_card {
namespace {

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    const model::CardLines& cards = contact.cards;
    if (!cards.missing.empty()) {
      found.push_back(finding_at(rule, context, contact,
                                 fmt::format("*{} ends before {}, which it must have; add the line, blank if the "
                                             "defaults will do",
                                             contact.written, cards.missing)));
    } else if (cards.misread > 0) {
      found.push_back(finding_at(rule, context, contact,
                                 fmt::format("*{} needs {} behind card 3, and line {} cannot be that card; add it, or "
                                             "the cards from A on are read one line too late",
                                             contact.written, cards.expected, cards.misread)));
      found.back().line = cards.misread;
    }
  }
  add_first(report, std::move(found), "more contacts lack a mandatory card");
}

}  // namespace

const Rule definition{{"GC401", "missing-card", Severity::error, "a contact lacks a card that its type must have",
                       Need::model, "The solver stops, or reads the next card as the missing one"},
                      run};

}  // namespace gapcheck::audit::rule::missing_card
