#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"

namespace gapcheck::audit::rule::surplus_card {
namespace {

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = context.model().contact(i);
    const model::CardLines& cards = contact.cards;
    if (cards.surplus == 0) continue;
    found.push_back(finding_at(
        rule, context, contact,
        fmt::format("*{} has {} {} behind card G, the last card; a card that this type does not have, or an option "
                    "word missing in the keyword (ID, MPP), moves all others: compare the lines with the cards",
                    contact.written, cards.surplus, cards.surplus == 1 ? "line" : "lines")));
    found.back().line = cards.first_surplus;
  }
  add_first(report, std::move(found), "more contacts have lines behind their last card");
}

}  // namespace

const Rule definition{{"GC402", "surplus-card", Severity::warning, "a contact has more lines than its type has cards",
                       Need::model, "The solver reads the surplus lines as something else, or stops"},
                      run};

}  // namespace gapcheck::audit::rule::surplus_card
