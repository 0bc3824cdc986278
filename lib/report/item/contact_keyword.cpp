#include "report/item/contact_keyword.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "report/item/describe.hpp"

namespace gapcheck::report {
namespace {

using CodeKeyword = std::pair<std::string_view, std::string_view>;

/// Codes without a leading letter, and those whose letter changes more than a prefix or suffix.
constexpr std::array<CodeKeyword, 24> keywords_by_code{{
    {"1", "SLIDING_ONLY"},
    {"2", "TIED_SURFACE_TO_SURFACE"},
    {"3", "SURFACE_TO_SURFACE"},
    {"4", "SINGLE_SURFACE"},
    {"5", "NODES_TO_SURFACE"},
    {"6", "TIED_NODES_TO_SURFACE"},
    {"7", "TIED_SHELL_EDGE_TO_SURFACE"},
    {"8", "TIEBREAK_NODES_TO_SURFACE"},
    {"9", "TIEBREAK_SURFACE_TO_SURFACE"},
    {"10", "ONE_WAY_SURFACE_TO_SURFACE"},
    {"13", "AUTOMATIC_SINGLE_SURFACE"},
    {"a13", "AIRBAG_SINGLE_SURFACE"},
    {"14", "ERODING_SURFACE_TO_SURFACE"},
    {"15", "ERODING_SINGLE_SURFACE"},
    {"16", "ERODING_NODES_TO_SURFACE"},
    {"17", "CONSTRAINT_SURFACE_TO_SURFACE"},
    {"18", "CONSTRAINT_NODES_TO_SURFACE"},
    {"20", "RIGID_NODES_TO_RIGID_BODY"},
    {"21", "RIGID_BODY_ONE_WAY_TO_RIGID_BODY"},
    {"22", "SINGLE_EDGE"},
    {"23", "DRAWBEAD"},
    {"25", "FORCE_TRANSDUCER"},
    {"26", "AUTOMATIC_GENERAL"},
    {"i26", "AUTOMATIC_GENERAL_INTERIOR"},
}};

std::string_view look_up(std::string_view code) {
  const auto found = std::find_if(keywords_by_code.begin(), keywords_by_code.end(),
                                  [&](const CodeKeyword& entry) { return entry.first == code; });
  return found == keywords_by_code.end() ? std::string_view() : found->second;
}

}  // namespace

std::string contact_keyword(const ContactSummary& contact) {
  constexpr std::string_view prefix = "CONTACT_";
  const std::string_view keyword = contact.keyword, code = contact.type;
  if (!keyword.empty()) return printable(keyword.starts_with(prefix) ? keyword.substr(prefix.size()) : keyword);
  if (const auto whole = look_up(code); !whole.empty()) return std::string(whole);
  if (code == "*") return "MORTAR";
  const std::string base(look_up(code.empty() ? code : code.substr(1)));
  if (base.empty()) return "?";
  switch (code.front()) {
    case 'a':
      return "AUTOMATIC_" + base;
    case 'm':
      return "FORMING_" + base;
    case 'o':
      return base + "_OFFSET";
    case 'b':
      return base + "_BEAM_OFFSET";
    case 'c':
      return base + "_CONSTRAINED_OFFSET";
    default:
      return "?";
  }
}

}  // namespace gapcheck::report
