#include "model/unknown_keyword.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "keyword/known_keywords.hpp"
#include "model/contact/contact_name.hpp"
#include "model/contact/nearest_contact_name.hpp"
#include "model/model.hpp"

namespace gapcheck::model {
namespace {

/// Names in messages are cut off here.
constexpr std::size_t longest_shown_name = 100;
/// What keywords begin with that hold contacts, mesh, sets and what else the audit's answer depends on.
constexpr std::array<std::string_view, 20> needed_keywords{"CONTACT",
                                                           "ELEMENT",
                                                           "NODE",
                                                           "PART",
                                                           "SECTION",
                                                           "MAT",
                                                           "SET",
                                                           "INCLUDE",
                                                           "PARAMETER",
                                                           "INITIAL",
                                                           "KEYWORD",
                                                           "END",
                                                           "RIGIDWALL",
                                                           "CONSTRAINED",
                                                           "CONTROL_CONTACT",
                                                           "CONTROL_SHELL",
                                                           "DEFINE_BOX",
                                                           "DEFINE_FRICTION",
                                                           "DEFINE_TRANSFORM",
                                                           "DEFINE_TRANSFORMATION"};

bool is_needed(std::string_view name) {
  return std::any_of(needed_keywords.begin(), needed_keywords.end(), [name](std::string_view beginning) {
    return name.starts_with(beginning) && (name.size() == beginning.size() || name[beginning.size()] == '_');
  });
}

}  // namespace

std::string nearest_keyword(const UnknownKeyword& unknown) {
  std::string nearest = keyword::nearest_keyword(unknown.name);
  if (!nearest.starts_with(contact_prefix) || parse_contact_name(nearest).known()) return nearest;
  const std::string contact = nearest_contact_name(nearest);
  return contact.empty() ? nearest : contact;
}

std::string describe(const UnknownKeyword& unknown, std::string_view nearest) {
  const std::string& name = unknown.name;
  const std::string beginning = keyword::known_beginning(name);
  std::string text = fmt::format("*{}{} is not a known {}", name.substr(0, longest_shown_name),
                                 name.size() > longest_shown_name ? "..." : "",
                                 beginning.empty() ? std::string("keyword") : fmt::format("form of *{}", beginning));
  if (unknown.count > 1) text += fmt::format(" (the deck has it {} times)", unknown.count);
  if (!unknown.read) text += ", so what it defines is not read";
  return text + (nearest.empty() ? std::string("; correct the name") : fmt::format("; did you mean *{}?", nearest));
}

Severity severity(const UnknownKeyword& unknown, std::string_view nearest) {
  if (!nearest.empty()) return is_needed(nearest) ? Severity::error : Severity::warning;
  const bool may_be_newer = keyword::standing_of(unknown.name) == keyword::Standing::other_form;
  return is_needed(unknown.name) && !may_be_newer ? Severity::error : Severity::warning;
}

void report_unknown_keywords(const Model& model, Diagnostics& diagnostics) {
  std::size_t names = 0;
  for (const UnknownKeyword& unknown : model.unknown_keywords) {
    const std::string nearest = ++names <= unknown_keywords_looked_up ? nearest_keyword(unknown) : std::string();
    diagnostics.add(
        {severity(unknown, nearest), model.file(unknown.place), unknown.place.line, describe(unknown, nearest)});
  }
}

}  // namespace gapcheck::model
