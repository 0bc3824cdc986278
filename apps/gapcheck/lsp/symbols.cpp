#include "lsp/symbols.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "base/number.hpp"

namespace gapcheck::app::lsp {
namespace {

using keyword::Card;
using keyword::CardLayout;
using keyword::Field;
using keyword::FieldType;
using keyword::IdKind;

struct Role {
  Kind kind;
  bool definition = false;
};

/// Keywords with the field that defines something.
struct Definer {
  std::string_view keyword;  ///< the name begins with it, as whole words
  std::string_view field;
  Kind kind;
};
constexpr std::array definers{
    Definer{"PART", "pid", Kind::part},
    Definer{"CONSTRAINED_NODAL_RIGID_BODY", "pid", Kind::part},
    Definer{"SECTION", "secid", Kind::section},
    Definer{"MAT", "mid", Kind::material},
    Definer{"EOS", "eosid", Kind::state_equation},
    Definer{"HOURGLASS", "hgid", Kind::hourglass},
    Definer{"CONTACT", "cid", Kind::contact},
    Definer{"DEFINE_CURVE", "lcid", Kind::curve},
    Definer{"DEFINE_TABLE", "tbid", Kind::curve},
    Definer{"DEFINE_FUNCTION", "fid", Kind::curve},
    Definer{"DEFINE_BOX", "boxid", Kind::box},
    Definer{"DEFINE_COORDINATE", "cid", Kind::system},
    Definer{"DEFINE_VECTOR", "vid", Kind::vector},
    Definer{"DEFINE_TRANSFORMATION", "tranid", Kind::transformation},
    Definer{"SET_NODE", "sid", Kind::node_set},
    Definer{"SET_PART", "sid", Kind::part_set},
    Definer{"SET_SEGMENT", "sid", Kind::segment_set},
    Definer{"SET_SHELL", "sid", Kind::shell_set},
    Definer{"SET_SOLID", "sid", Kind::solid_set},
    Definer{"SET_BEAM", "sid", Kind::beam_set},
    Definer{"SET_TSHELL", "sid", Kind::thick_shell_set},
    Definer{"SET_DISCRETE", "sid", Kind::discrete_set},
    Definer{"NODE", "nid", Kind::node},
    Definer{"ELEMENT", "eid", Kind::element},
};
/// They name what others define.
constexpr std::array<std::string_view, 5> only_name{"PART_MOVE", "PART_DUPLICATE", "MAT_ADD", "PART_MODES",
                                                    "NODE_TRANSFORM"};

bool begins_with(std::string_view name, std::string_view beginning) {
  return name.starts_with(beginning) && (name.size() == beginning.size() || name[beginning.size()] == '_');
}

bool names_only(std::string_view keyword) {
  return std::any_of(only_name.begin(), only_name.end(),
                     [keyword](std::string_view name) { return begins_with(keyword, name); });
}

bool is_set(Kind kind) { return kind >= Kind::node_set && kind <= Kind::any_set; }

/// The kind of set that a keyword *SET_… has; any_set for all others.
Kind set_kind(std::string_view keyword) {
  for (const Definer& definer : definers)
    if (is_set(definer.kind) && begins_with(keyword, definer.keyword)) return definer.kind;
  return Kind::any_set;
}

/// Which kind of set a field names; the manual's names say it, mostly.
Kind set_named_by(std::string_view keyword, std::string_view field) {
  if (const Kind own = set_kind(keyword); own != Kind::any_set) return own;
  if (field.starts_with("nsid") || field.starts_with("nset") || field == "nodes") return Kind::node_set;
  if (field.starts_with("psid") || field.starts_with("pset") || field == "parts") return Kind::part_set;
  if (field.starts_with("ssid") && keyword.find("SEGMENT") != std::string_view::npos) return Kind::segment_set;
  return Kind::any_set;
}

/// What a surface of a contact is, by the type beside it.
std::optional<Kind> surface_kind(const Card& card, std::string_view field) {
  const std::string type = field == "surfa" ? "surfatyp" : "surfbtyp";
  constexpr std::array kinds{Kind::segment_set, Kind::shell_set, Kind::part_set, Kind::part, Kind::node_set};
  const std::int64_t value = card.integer(type);
  if (value == 6) return Kind::part_set;
  return value >= 0 && value < 5 ? std::optional(kinds[static_cast<std::size_t>(value)]) : std::nullopt;
}

std::optional<Kind> kind_of(std::string_view keyword, const Field& field) {
  switch (field.id) {
    case IdKind::node:
      return Kind::node;
    case IdKind::element:
      return Kind::element;
    case IdKind::part:
      return Kind::part;
    case IdKind::material:
      return field.name == "eosid" ? Kind::state_equation : Kind::material;
    case IdKind::function:
      return Kind::curve;
    case IdKind::set:
      return set_named_by(keyword, field.name);
    case IdKind::define:
      if (field.name.find("box") != std::string::npos) return Kind::box;
      if (field.name.starts_with("vid")) {
        // Those of springs are of *DEFINE_SD_ORIENTATION.
        const bool of_springs =
            begins_with(keyword, "ELEMENT_DISCRETE") || begins_with(keyword, "DEFINE_SD_ORIENTATION");
        return of_springs ? std::nullopt : std::optional(Kind::vector);
      }
      return field.name.starts_with("tran") ? Kind::transformation : Kind::system;
    case IdKind::other:
      if (field.name == "secid") return Kind::section;
      if (field.name == "hgid") return Kind::hourglass;
      return std::nullopt;
    case IdKind::plain:
      return std::nullopt;
  }
  return std::nullopt;
}

/// Whether an entry for this card and field is what the keyword defines: the first of that name in its cards.
std::optional<Role> role_of(const Keyword& keyword, const CardLayout& layout, std::size_t at, const Card& card) {
  const Field& field = layout.fields[at];
  if (field.type != FieldType::integer) return std::nullopt;
  if (!names_only(keyword.name))
    for (const Definer& definer : definers)
      if (field.name == definer.field && begins_with(keyword.name, definer.keyword)) return Role{definer.kind, true};
  if (begins_with(keyword.name, "CONTACT") && (field.name == "surfa" || field.name == "surfb")) {
    const auto kind = surface_kind(card, field.name);
    return kind ? std::optional(Role{*kind, false}) : std::nullopt;
  }
  // *SET_PART_GENERAL: the word in front says what the numbers are.
  if (layout.fields.front().name == "option" && field.name.size() == 2 && field.name.front() == 'e')
    return card.text(std::size_t{0}) == "PART" ? std::optional(Role{Kind::part, false}) : std::nullopt;
  const auto kind = kind_of(keyword.name, field);
  return kind ? std::optional(Role{*kind, false}) : std::nullopt;
}

/// The parameters in a field: `&name`, also in expressions.
void add_parameters(std::string_view written, const Occurrence& field, std::vector<Occurrence>& found) {
  for (std::size_t at = written.find('&'); at != std::string_view::npos; at = written.find('&', at + 1)) {
    std::size_t end = at + 1;
    while (end < written.size() && in_name(written[end])) ++end;
    if (end == at + 1) continue;
    Occurrence parameter = field;
    parameter.symbol = {Kind::parameter, 0, lower_case(written.substr(at + 1, end - at - 1))};
    parameter.begin = field.begin + at + 1;
    parameter.end = field.begin + end;
    found.push_back(std::move(parameter));
  }
}

/// "R t" in *PARAMETER: its name, behind the letter of the type.
void add_parameter_definition(std::string_view written, Occurrence field, std::vector<Occurrence>& found) {
  if (written.size() < 2) return;
  const std::string_view name = trimmed(written.substr(1));
  if (name.empty()) return;
  field.symbol = {Kind::parameter, 0, lower_case(name)};
  field.definition = true;
  field.begin += static_cast<std::size_t>(name.data() - written.data());
  field.end = field.begin + name.size();
  // The letter has the first column.
  field.field_begin = field.begin;
  field.field_end = field.end;
  if (field.width > 0) ++field.column, --field.width;
  found.push_back(std::move(field));
}

bool is_parameter_name(const Keyword& keyword, const Field& field) {
  if (!begins_with(keyword.name, "PARAMETER") || keyword.name == "PARAMETER_DUPLICATION") return false;
  return field.name.starts_with("name") || field.name.starts_with("prmr");
}

}  // namespace

std::string_view name_of(Kind kind) {
  constexpr std::array<std::string_view, 23> names{"part",
                                                   "section",
                                                   "material",
                                                   "equation of state",
                                                   "hourglass control",
                                                   "contact",
                                                   "set of nodes",
                                                   "set of parts",
                                                   "set of segments",
                                                   "set of shells",
                                                   "set of solids",
                                                   "set of beams",
                                                   "set of thick shells",
                                                   "set of discrete elements",
                                                   "set",
                                                   "curve",
                                                   "box",
                                                   "coordinate system",
                                                   "vector",
                                                   "transformation",
                                                   "node",
                                                   "element",
                                                   "parameter"};
  return names[static_cast<std::size_t>(kind)];
}

bool Symbol::same(const Symbol& other) const {
  const bool kinds = kind == other.kind ||
                     (is_set(kind) && is_set(other.kind) && (kind == Kind::any_set || other.kind == Kind::any_set));
  return kinds && id == other.id && name == other.name;
}

std::vector<Occurrence> occurrences(const FileView& file, const CardLine& at, std::string_view line,
                                    std::uint32_t number) {
  std::vector<Occurrence> found;
  if (at.layout == nullptr) return found;
  const keyword::Block block = file.scope.block(*at.keyword);
  Diagnostics ignored;  // faults in fields are told elsewhere
  const Card card(file.scope.deck(), block, *at.layout, line, number + 1, ignored);
  for (std::size_t i = 0; i < card.size(); ++i) {
    const std::string_view written = card.written(i);
    if (written.empty()) continue;
    Occurrence each;
    each.line = number;
    each.begin = static_cast<std::size_t>(written.data() - line.data());
    each.end = each.begin + written.size();
    each.field_begin = each.begin;
    each.field_end = each.end;
    if (!card.free_format()) each.column = card.cell(i).column, each.width = card.cell(i).width;
    if (is_parameter_name(*at.keyword, at.layout->fields[i])) {
      add_parameter_definition(written, each, found);
      continue;
    }
    add_parameters(written, each, found);
    const auto role = role_of(*at.keyword, *at.layout, i, card);
    if (!role) continue;
    each.by_parameter = keyword::is_parameter_reference(written);
    const std::int64_t id = card.integer(i);
    if (id == 0) continue;
    each.symbol = {role->kind, id < 0 ? -id : id};
    each.definition = role->definition;
    if (written.starts_with('-') && !each.by_parameter) ++each.begin;
    found.push_back(std::move(each));
  }
  return found;
}

std::optional<Occurrence> occurrence_at(const FileView& file, Place place) {
  const CardLine card = card_at(*file.text, *file.outline, place.line);
  std::optional<Occurrence> best;
  for (Occurrence& each : occurrences(file, card, file.text->line(place.line), place.line)) {
    // The cursor may be behind the last character.
    if (place.byte < each.begin || place.byte > each.end) continue;
    if (!best || each.symbol.kind == Kind::parameter) best = std::move(each);
  }
  return best;
}

namespace {

/// The text behind the other fields of a line.
std::string heading_in(std::string_view line, const CardLayout& layout) {
  const std::size_t comma = line.find(',');
  if (comma != std::string_view::npos && comma < layout.fields.back().column)
    return std::string(trimmed(line.substr(comma + 1)));
  return std::string(trimmed(line.substr(std::min<std::size_t>(layout.fields.back().column, line.size()))));
}

/// Whether a keyword can have the symbol at all.
bool worth_reading(const Keyword& keyword, const Symbol& symbol, Reach reach) {
  const bool parameter = symbol.kind == Kind::parameter;
  if (reach == Reach::everything) return true;
  if (reach == Reach::cards) return !is_mesh(keyword);
  if (parameter) return begins_with(keyword.name, "PARAMETER");
  return std::any_of(definers.begin(), definers.end(), [&](const Definer& definer) {
    return begins_with(keyword.name, definer.keyword) && symbol.same({definer.kind, symbol.id, symbol.name});
  });
}

/// How an id of the model may be written in a file: with the offsets of its include taken off.
std::vector<std::string> spellings(const FileView& file, const Symbol& symbol) {
  std::vector<std::string> texts;
  if (symbol.kind == Kind::parameter) return {"&", "*"};
  texts.push_back(std::to_string(symbol.id));
  for (const std::int64_t offset : file.scope.offsets()) texts.push_back(std::to_string(symbol.id - offset));
  return texts;
}

bool may_hold(std::string_view line, const std::vector<std::string>& texts) {
  return line.find('&') != std::string_view::npos || line.find('<') != std::string_view::npos ||
         std::any_of(texts.begin(), texts.end(),
                     [line](const std::string& text) { return line.find(text) != std::string_view::npos; });
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

void for_each_occurrence(const FileView& file, const Symbol& symbol, Reach reach,
                         const std::function<bool(const Occurrence&)>& visit) {
  const std::vector<std::string> texts = spellings(file, symbol);
  bool go_on = true;
  for (const Keyword& keyword : *file.outline) {
    if (!go_on) return;
    if (!worth_reading(keyword, symbol, reach)) continue;
    const bool of_parameters = begins_with(keyword.name, "PARAMETER");
    LineCards cards(*file.text, keyword);
    CardLine card{&keyword, nullptr, 0};
    file.text->for_each_line(keyword.line + 1, keyword.end, [&](std::uint32_t number, std::string_view line) {
      if (line.starts_with('$')) return true;
      card.layout = cards.next(line);
      if (card.layout == nullptr || (!of_parameters && !may_hold(line, texts))) return true;
      for (const Occurrence& each : occurrences(file, card, line, number))
        if (each.symbol.same(symbol)) go_on = go_on && visit(each);
      return go_on;
    });
  }
}

std::vector<Defined> definitions_in(const FileView& file, const Keyword& keyword) {
  std::vector<Defined> found;
  if (is_mesh(keyword)) return found;
  const CardOrder order = card_order(*file.text, keyword);
  CardLine card{&keyword, nullptr, 0};
  std::string title;
  file.text->for_each_line(keyword.line + 1, keyword.end, [&](std::uint32_t number, std::string_view line) {
    if (line.starts_with('$')) return true;
    card.layout = order.at(card.row++);
    if (card.layout == nullptr) return true;
    const bool text = card.layout->fields.back().type == FieldType::text;
    const bool heading = text && card.layout->fields.back().name == "heading";
    for (Occurrence& each : occurrences(file, card, line, number))
      if (each.definition) found.push_back({std::move(each), heading ? heading_in(line, *card.layout) : title});
    title = text && card.layout->fields.size() == 1 ? std::string(trimmed(line)) : std::string();
    // Behind its first cards a set or a curve only has numbers.
    return order.head.empty() || card.row < order.head.size() || order.cycle.size() != 1;
  });
  return found;
}

}  // namespace gapcheck::app::lsp
