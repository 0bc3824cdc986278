#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "base/number.hpp"
#include "keyword/layout.hpp"
#include "keyword/upper_case.hpp"
#include "lsp/card_order.hpp"
#include "lsp/features/features.hpp"
#include "model/contact/contact_name.hpp"

namespace gapcheck::app::lsp {
namespace {

constexpr std::size_t most_items = 1000;

// Numbers of the protocol.
constexpr int kind_keyword = 14, kind_option = 20;

constexpr std::array<std::string_view, 7> contact_options{
    "ID", "TITLE", "MPP", "MORTAR", "THERMAL", "THERMAL_FRICTION", "ORTHO_FRICTION"};

void add_if(bool holds, std::string name, std::set<std::string>& names) {
  if (holds) names.insert(std::move(name));
}

/// A name with the option words that it can still get.
std::set<std::string> with_options(const std::string& name) {
  std::set<std::string> names;
  const model::ContactName contact = model::parse_contact_name(name);
  if (name.starts_with("CONTACT_") && contact.kind != nullptr) {
    for (const std::string_view option : contact_options) {
      const std::string longer = name + "_" + std::string(option);
      const model::ContactName with = model::parse_contact_name(longer);
      add_if(with.kind == contact.kind && !(with.options == contact.options), longer, names);
    }
    return names;
  }
  const keyword::KeywordLayout* layout = keyword::find_layout(name);
  if (layout == nullptr) return names;
  for (const char* option : {"TITLE", "ID"}) add_if(layout->card(option) != nullptr, name + "_" + option, names);
  return names;
}

std::set<std::string> names_with(const std::string& prefix) {
  std::set<std::string> names;
  for (const std::string_view name : keyword::layout_names(prefix)) names.emplace(name);
  for (const std::string_view name : model::known_contact_names()) {
    std::string whole = "CONTACT_" + std::string(name);
    add_if(whole.starts_with(prefix), whole, names);
  }
  names.erase("CONTACT");
  return names;
}

}  // namespace

json completion(const Question& question, Place place) {
  const std::string_view line = question.text().line(place.line);
  const std::string_view before = line.substr(0, place.byte);
  if (!before.starts_with('*') || before.find_first_of(" \t") != std::string_view::npos) return nullptr;
  const std::string prefix = keyword::upper_case(before.substr(1));
  std::set<std::string> options;
  for (const std::string& name : with_options(prefix)) options.insert(name);
  if (prefix.ends_with('_')) options.merge(with_options(prefix.substr(0, prefix.size() - 1)));
  const std::set<std::string> names = names_with(prefix);
  // The last words may be options half written.
  if (names.empty())
    if (const std::size_t cut = prefix.rfind('_'); cut != std::string::npos)
      for (const std::string& name : with_options(prefix.substr(0, cut)))
        add_if(name.starts_with(prefix), name, options);
  // What is behind the cursor up to the next blank belongs to the name.
  const std::size_t end = std::min(line.find_first_of(" \t", place.byte), line.size());
  const json range = range_in(line, place.line, 0, end, question.encoding);
  json items = json::array();
  const auto add = [&](const std::string& name, int kind) {
    if (items.size() == most_items) return;
    const std::string text = "*" + name;
    items.push_back(
        {{"label", text}, {"kind", kind}, {"filterText", text}, {"textEdit", {{"range", range}, {"newText", text}}}});
  };
  for (const std::string& name : options)
    if (!names.contains(name)) add(name, kind_option);
  for (const std::string& name : names) add(name, kind_keyword);
  return {{"isIncomplete", true}, {"items", std::move(items)}};
}

}  // namespace gapcheck::app::lsp
