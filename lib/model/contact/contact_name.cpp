#include "model/contact/contact_name.hpp"

#include <algorithm>

#include "keyword/layout.hpp"

namespace gapcheck::model {
namespace {

std::string joined(const std::vector<std::string_view>& words) {
  std::string name;
  for (const std::string_view word : words) {
    if (!name.empty()) name += '_';
    name += word;
  }
  return name;
}

}  // namespace

std::vector<std::string_view> words_of(std::string_view name) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t cut = name.find('_');
    words.push_back(name.substr(0, cut));
    if (cut == std::string_view::npos) return words;
    name.remove_prefix(cut + 1);
  }
}

ContactName parse_contact_name(std::string_view written) {
  ContactName name;
  ContactOptions& options = name.options;
  std::vector<std::string_view> words = words_of(written), kept;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string_view word = words[i];
    const bool friction = i + 1 < words.size() && words[i + 1] == "FRICTION";
    if (word == "ID" || word == "TITLE")
      options.id = true;
    else if (word == "MPP")
      options.mpp = true;
    else if (word == "MORTAR")
      options.mortar = true;
    else if (word == "SMOOTH")
      options.smooth = true;
    else if (word == "THERMAL" && words[1] != "2D")
      options.thermal = true, options.thermal_friction = options.thermal_friction || friction, i += friction ? 1 : 0;
    else if (word == "ORTHO" && friction)
      options.ortho_friction = true, ++i;
    else
      kept.push_back(word);
  }
  const std::string type = joined(kept);
  name.kind = find_contact_kind(type);
  if (name.kind != nullptr && options.mortar && !has_mortar_form(*name.kind)) name.kind = nullptr;
  name.own_layout = name.kind == nullptr && has_own_layout(type);
  name.modifier = name.own_layout && only_modifies(type);
  name.bare = std::string(contact_prefix) + type + std::string(options.mortar ? mortar_suffix : std::string_view());
  return name;
}

const std::vector<std::string_view>& known_contact_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const ContactKind& kind : contact_kinds()) list.push_back(kind.name);
    std::sort(list.begin(), list.end());
    for (std::string_view name : keyword::layout_names(contact_prefix))
      if (name.remove_prefix(contact_prefix.size()); has_own_layout(name)) list.push_back(name);
    return list;
  }();
  return names;
}

}  // namespace gapcheck::model
