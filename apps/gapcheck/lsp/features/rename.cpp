#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <variant>

#include "base/number.hpp"
#include "keyword/parameters.hpp"
#include "lsp/features/features.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

constexpr std::size_t most_edits = 5'000'000;

Diagnostic refused(std::string why) { return plain_error(std::move(why)); }

/// The longest name of a parameter that the solver reads.
constexpr std::size_t longest_name = 9;

/// What a parameter or an id may be called; empty: it may.
std::string fault_of_name(const Symbol& symbol, const std::string& name) {
  if (symbol.kind == Kind::parameter) {
    const bool fine = !name.empty() && name.size() <= longest_name && keyword::is_plain_name(name);
    return fine ? "" : fmt::format("a parameter has a name of at most {} letters and digits", longest_name);
  }
  const auto id = parse_integer(name);
  const bool digits = !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
  return id && *id > 0 && digits ? "" : "an id is a whole number above 0";
}

Symbol renamed(Symbol symbol, const std::string& name) {
  if (symbol.kind != Kind::parameter) {
    symbol.id = parse_integer(name).value_or(0);
    return symbol;
  }
  symbol.name = lower_case(name);
  return symbol;
}

/// Files that the deck has more than once: a line of them means several things.
std::set<std::string> files_read_twice(const FileView& file) {
  std::set<std::string> once, twice;
  if (!file.scope.whole()) return twice;
  for (const keyword::SourceFile& each : file.scope.deck().files()) {
    const std::string path = canonical(each.path);
    if (!once.insert(path).second) twice.insert(path);
  }
  return twice;
}

/// Keywords that name things in lines which the card layouts do not tell apart.
bool is_unsure(std::string_view name) {
  return name.starts_with("DEFORMABLE_TO_RIGID") || name.starts_with("RIGID_DEFORMABLE") ||
         name.starts_with("INITIAL_VELOCITY_GENERATION") || name.find("_GENERATE") != std::string_view::npos;
}

/// True if the line holds the number as a whole, not as digits of a longer one.
bool has_number(std::string_view line, std::string_view number) {
  const auto digit = [&](std::size_t at) { return at < line.size() && line[at] >= '0' && line[at] <= '9'; };
  for (std::size_t at = line.find(number); at != std::string_view::npos; at = line.find(number, at + 1))
    if (!(at > 0 && digit(at - 1)) && !digit(at + number.size())) return true;
  return false;
}

/// Whether a line of "first last" pairs has an id inside a range.
bool in_range(std::string_view line, std::int64_t id) {
  std::optional<std::int64_t> first;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t begin = line.find_first_of("0123456789", at);
    if (begin == std::string_view::npos) break;
    at = std::min(line.find_first_not_of("0123456789", begin), line.size());
    const auto number = parse_integer(line.substr(begin, at - begin));
    if (!number) return false;
    if (first && *first <= id && id <= *number) return true;
    first = first ? std::nullopt : number;
  }
  return false;
}

/// Calls visit(name in lower case) for each parameter in a line until it returns true, as any_of.
bool any_parameter(std::string_view line, const std::function<bool(const std::string&)>& visit) {
  for (std::size_t at = line.find('&'); at != std::string_view::npos; at = line.find('&', at + 1)) {
    std::size_t end = at + 1;
    while (end < line.size() && in_name(line[end])) ++end;
    if (visit(lower_case(line.substr(at + 1, end - at - 1)))) return true;
  }
  return false;
}

/// Whether the value of a parameter in a line is that whole number.
bool gives(const FileView& file, const keyword::Block& block, std::string_view line, std::int64_t number) {
  return any_parameter(line, [&](const std::string& name) {
    const keyword::ParameterValue* value = file.scope.deck().parameters().find(name, block.scope, block.order);
    return value != nullptr && std::holds_alternative<std::int64_t>(*value) && std::get<std::int64_t>(*value) == number;
  });
}

/// A line of a card that is not known, with the parameter in it; empty: there is none.
std::string unread_line(const FileView& file, const std::string& name) {
  std::string where;
  for (const Keyword& keyword : *file.outline) {
    LineCards cards(*file.text, keyword);
    file.text->for_each_line(keyword.line + 1, keyword.end, [&](std::uint32_t number, std::string_view line) {
      if (line.starts_with('$') || cards.next(line) != nullptr) return true;
      if (any_parameter(line, [&](const std::string& each) { return each == name; }))
        where = fmt::format("line {} of {} in *{} has it in a card that is not known; change it by hand", number + 1,
                            file.path, keyword.name);
      return where.empty();
    });
    if (!where.empty()) break;
  }
  return where;
}

/// A line that may name one of the ids although the layouts do not say so; empty: there is none.
std::string unsure_line(const FileView& file, std::int64_t from, std::int64_t to) {
  std::string where;
  const std::set<std::int64_t> offsets = file.scope.offsets();
  for (const Keyword& keyword : *file.outline) {
    const bool all = is_unsure(keyword.name);
    if (!where.empty() || !(all || keyword.name.starts_with("ELEMENT"))) continue;
    LineCards cards(*file.text, keyword);
    const keyword::Block block = file.scope.block(keyword);
    const bool ranges = keyword.name.find("_GENERATE") != std::string::npos;
    const auto names = [&](std::string_view line, std::int64_t offset) {
      return has_number(line, std::to_string(from - offset)) || gives(file, block, line, from - offset) ||
             (ranges && (in_range(line, from - offset) || in_range(line, to - offset)));
    };
    file.text->for_each_line(keyword.line + 1, keyword.end, [&](std::uint32_t number, std::string_view line) {
      if (line.starts_with('$')) return true;
      const bool known = cards.next(line) != nullptr && cards.sure();
      const bool found =
          (all || !known) &&
          (names(line, 0) || std::ranges::any_of(offsets, [&](std::int64_t o) { return names(line, o); }));
      if (found)
        where =
            fmt::format("line {} of {} in *{} may name {} or {}, in a way that is not understood; change it by hand",
                        number + 1, file.path, keyword.name, from, to);
      return !found;
    });
  }
  return where;
}

/// A line of *PARAMETER_EXPRESSION whose expression has the parameter without "&"; empty: there is none.
std::string bare_name(const FileView& file, const std::string& name) {
  constexpr std::size_t of_name = 10;  // columns of the definition
  std::string where;
  for (const Keyword& keyword : *file.outline) {
    if (!keyword.name.starts_with("PARAMETER_EXPRESSION")) continue;
    file.text->for_each_line(keyword.line + 1, keyword.end, [&](std::uint32_t number, std::string_view line) {
      const std::string lower = lower_case(line.substr(std::min(of_name, line.size())));
      for (std::size_t at = lower.find(name); at != std::string::npos; at = lower.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        const bool inside = (at > 0 && in_name(lower[at - 1])) || (end < lower.size() && in_name(lower[end]));
        if (!inside && !(at > 0 && lower[at - 1] == '&') && where.empty())
          where = fmt::format("line {} of {} has it without &; change it by hand", number + 1, file.path);
      }
      return where.empty();
    });
  }
  return where;
}

/// The text that replaces what is written at an occurrence: the id without the offset of its include.
std::string text_there(const FileView& file, const Occurrence& at, const Symbol& to, const std::string& name) {
  if (to.kind == Kind::parameter) return name;
  const std::string_view written = file.text->line(at.line).substr(at.begin, at.end - at.begin);
  const std::int64_t offset = at.symbol.id - parse_integer(written).value_or(at.symbol.id);
  return std::to_string(to.id - offset);
}

/// A field with what it names renamed.
struct FieldEdit {
  std::uint32_t line = 0;
  std::size_t begin = 0, end = 0;
  std::string text;
};

/// Replaces what is written in a field of fixed columns so that it stays in them, and all others in theirs.
FieldEdit within_columns(const Occurrence& at, std::string_view line, FieldEdit edit) {
  if (at.width == 0) return edit;
  const std::size_t size = edit.text.size(), last = std::min(at.column + at.width, line.size());
  while (size > edit.end - edit.begin && edit.begin > at.column && line[edit.begin - 1] == ' ') --edit.begin;
  while (size > edit.end - edit.begin && edit.end < last && line[edit.end] == ' ') ++edit.end;
  if (size < edit.end - edit.begin) edit.text.insert(0, edit.end - edit.begin - size, ' ');
  return edit;
}

/// The edits of one file, field by field.
class FileEdits {
 public:
  FileEdits(const FileView& file, const Symbol& to, const std::string& name) : file_(file), to_(to), name_(name) {}
  /// Why an occurrence cannot be changed; empty: it is.
  std::string add(const Occurrence& each) {
    const std::string_view line = file_.text->line(each.line);
    const auto where = [&] { return fmt::format("line {} of {}", each.line + 1, file_.path); };
    if (each.by_parameter) return where() + " gives it by a parameter; change the value of the parameter";
    if (each.symbol.kind == Kind::any_set)
      return where() + " names a set of this number, but does not say of which kind; change it by hand";
    if (to_.kind != Kind::parameter && text_there(file_, each, to_, name_).find_first_of("-0") == 0)
      return where() + " is in an include whose offset is too large for that number";
    if (each.width > 0 && line.find('\t') != std::string_view::npos) return where() + " has tabs; put blanks there";
    const bool again = !edits_.empty() && edits_.back().line == each.line && begin_ == each.field_begin;
    if (!again) {
      begin_ = done_ = each.field_begin;
      edits_.push_back({each.line, each.field_begin, each.field_end, {}});
      written_.clear();
    }
    // What is before it in the field, it, and the rest, which the next one in the field replaces.
    written_ += line.substr(done_, each.begin - done_);
    written_ += text_there(file_, each, to_, name_);
    done_ = each.end;
    FieldEdit edit{each.line, each.field_begin, each.field_end, written_};
    edit.text += line.substr(done_, each.field_end - done_);
    if (each.width > 0 && edit.text.size() > each.width)
      return fmt::format("{} has {} columns for it, too few for {}", where(), each.width, edit.text);
    edits_.back() = within_columns(each, line, std::move(edit));
    return {};
  }
  [[nodiscard]] bool empty() const { return edits_.empty(); }
  [[nodiscard]] std::size_t size() const { return edits_.size(); }
  [[nodiscard]] json list(Encoding encoding) const {
    json all = json::array();
    for (const FieldEdit& edit : edits_)
      all.push_back({{"range", range_in(file_.text->line(edit.line), edit.line, edit.begin, edit.end, encoding)},
                     {"newText", edit.text}});
    return all;
  }

 private:
  const FileView& file_;
  const Symbol& to_;
  const std::string& name_;
  std::vector<FieldEdit> edits_;
  std::string written_;               ///< of the last field so far
  std::size_t begin_ = 0, done_ = 0;  ///< where that field begins, and up to where it is written
};

}  // namespace

json prepare_rename(const Question& question, Place place) {
  const auto at = occurrence_at(question.file(), place);
  if (!at || at->by_parameter) return nullptr;
  const std::string_view line = question.text().line(place.line);
  return {{"range", range_in(line, place.line, at->begin, at->end, question.encoding)},
          {"placeholder", std::string(line.substr(at->begin, at->end - at->begin))}};
}

Result<json> rename(const Question& question, Place place, const std::string& name) {
  const auto at = occurrence_at(question.file(), place);
  if (!at) return refused("there is no id or parameter here that can get another name");
  if (const std::string fault = fault_of_name(at->symbol, name); !fault.empty()) return refused(fault);
  if (at->symbol.kind == Kind::any_set)
    return refused("this field does not say what kind of set it names; start from the *SET");
  const Symbol to = renamed(at->symbol, name);
  if (to.same(at->symbol)) return json{{"changes", json::object()}};
  if (const auto taken = find_definition(question.deck, to))
    return refused(fmt::format("{} {} is there already, in line {} of {}", name_of(to.kind), name, taken->at.line + 1,
                               taken->file.path));
  const std::set<std::string> twice = files_read_twice(question.file());
  json changes = json::object();
  std::string fault;
  std::size_t count = 0;
  question.deck.for_each([&](const FileView& file) {
    FileEdits edits(file, to, name);
    for_each_occurrence(file, at->symbol, Reach::everything, [&](const Occurrence& each) {
      fault = twice.contains(canonical(file.path)) ? file.path + " is included more than once; change it by hand"
                                                   : edits.add(each);
      if (fault.empty() && count + edits.size() > most_edits)
        fault = fmt::format("it is named more than {} times", most_edits);
      return fault.empty();
    });
    if (fault.empty())
      fault = to.kind == Kind::parameter ? bare_name(file, at->symbol.name) : unsure_line(file, at->symbol.id, to.id);
    if (fault.empty() && to.kind == Kind::parameter) fault = unread_line(file, at->symbol.name);
    count += edits.size();
    if (!edits.empty()) changes[uri_of(file.path)] = edits.list(question.encoding);
    return fault.empty();
  });
  if (!fault.empty()) return refused(fault);
  return json{{"changes", std::move(changes)}};
}

}  // namespace gapcheck::app::lsp
