#include "report/item/contact_keyword.hpp"

#include <string_view>

#include "model/contact/contact_kind.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::report {

std::string contact_keyword(const ContactSummary& contact) {
  const std::string_view keyword = contact.keyword, prefix = model::contact_prefix;
  if (!keyword.empty()) return printable(keyword.starts_with(prefix) ? keyword.substr(prefix.size()) : keyword);
  const std::string known = model::keyword_of_printed(contact.type);
  return known.empty() ? "?" : known;
}

}  // namespace gapcheck::report
