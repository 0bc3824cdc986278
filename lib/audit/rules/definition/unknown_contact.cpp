#include <fmt/format.h>

#include <map>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "model/contact/nearest_contact_name.hpp"

namespace gapcheck::audit::rule::unknown_contact {
namespace {

/// Names in messages are cut off here.
constexpr std::size_t shown = 100;
/// Most names for which a similar one is searched; a file with more of them is not a deck.
constexpr std::size_t names_looked_up = 100;

std::string words(const model::Contact& contact, bool look_up) {
  std::string text = fmt::format("*{}{} is not a contact keyword", contact.written.substr(0, shown),
                                 contact.written.size() > shown ? "..." : "");
  const std::string nearest = look_up ? model::nearest_contact_name(contact.written) : std::string();
  return nearest.empty() ? text + "; correct the name" : text + "; did you mean *" + nearest + "?";
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::map<std::string_view, std::vector<const model::Contact*>> unknown;
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if (!contact.known) unknown[contact.written].push_back(&contact);
  }
  std::size_t names = 0;
  for (const auto& [name, contacts] : unknown) {
    const std::string text = words(*contacts.front(), ++names <= names_looked_up);
    std::vector<Finding> found;
    for (const model::Contact* contact : contacts) found.push_back(finding_at(rule, context, *contact, text));
    add_first(report, std::move(found), "more contacts have this unknown keyword");
  }
}

}  // namespace

const Rule definition{{"GC403", "unknown-contact", Severity::error, "the solver knows no contact of this name",
                       Need::model, "The solver stops at this keyword"},
                      run};

}  // namespace gapcheck::audit::rule::unknown_contact
