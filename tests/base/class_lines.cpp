#include "class_lines.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>

namespace gapcheck::architecture_test {

namespace {

class Scanner {
 public:
  explicit Scanner(std::string code) : code_(std::move(code)) { blank_directives(); }
  std::vector<Definition> run() {
    scope(0);
    return std::move(found_);
  }

 private:
  /// Declarations from `at` to the closing brace of their scope; returns the position behind it.
  std::size_t scope(std::size_t at);
  /// Position behind the brace that closes the one at `open`.
  [[nodiscard]] std::size_t behind_block(std::size_t open) const;
  /// What the brace at `open` opens after the declaration that begins at `begin`; returns where to go on.
  std::size_t block(std::size_t begin, std::size_t open);
  void blank_directives();
  void add(Definition::Kind kind, const std::string& of, std::size_t begin, std::size_t end);
  [[nodiscard]] std::size_t line(std::size_t at) const {
    return 1 +
           static_cast<std::size_t>(std::count(code_.begin(), code_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }

  std::string code_;
  std::vector<Definition> found_;
};

/// Parameters of templates name classes too: `template <class T>`.
std::string without_template_head(const std::string& text) {
  static const std::regex head(R"(^\s*template\s*<)");
  std::smatch match;
  if (!std::regex_search(text, match, head)) return text;
  std::size_t at = static_cast<std::size_t>(match.length());
  for (int open = 1; open > 0 && at < text.size(); ++at) open += text[at] == '<' ? 1 : text[at] == '>' ? -1 : 0;
  return without_template_head(text.substr(at));
}

/// Constructors give members their values in braces before the body begins: `: a_{1}, b_{2} {`.
bool gives_member_value(const std::string& declaration) {
  static const std::regex list(R"(\)[^()]*[^:]:[^:])");
  const std::size_t last = declaration.find_last_not_of(" \n");
  return last != std::string::npos && in_name(declaration[last]) && std::regex_search(declaration, list);
}

std::size_t Scanner::scope(std::size_t at) {
  std::size_t begin = at;
  while (at < code_.size()) {
    switch (code_[at]) {
      case ';':
        begin = ++at;
        break;
      case '}':
        return at + 1;
      case '{':
        if (gives_member_value(code_.substr(begin, at - begin))) {
          at = behind_block(at);
        } else {
          begin = at = block(begin, at);
        }
        break;
      default:
        ++at;
    }
  }
  return at;
}

std::size_t Scanner::behind_block(std::size_t open) const {
  int depth = 0;
  for (std::size_t at = open; at < code_.size(); ++at) {
    depth += code_[at] == '{' ? 1 : code_[at] == '}' ? -1 : 0;
    if (depth == 0) return at + 1;
  }
  return code_.size();
}

std::size_t Scanner::block(std::size_t begin, std::size_t open) {
  static const std::regex space(R"(^\s*(inline\s+)?namespace\b)"), enumeration(R"(^\s*enum\b)"),
      classes(
          R"(\b(?:class|struct|union)\s+(?:\[\[[^\]]*\]\]\s*)*(?:\w+::)*(\w+)(?:<[^{]*>)?(?:\s+final)?\s*(?::[^:]|$))"),
      members(R"((\w+)(?:<[^<>()]*>)?::(?:~?\w+|operator\s*\(\)|operator[^(]*)\s*\()");
  const std::string whole = code_.substr(begin, open - begin);
  const std::string declaration = without_template_head(whole);
  std::smatch match;
  if (std::regex_search(declaration, match, space)) return scope(open + 1);
  const std::size_t end = behind_block(open);
  if (std::regex_search(declaration, match, enumeration)) return end;
  const std::size_t visible = begin + std::min(whole.find_first_not_of(" \n\t"), whole.size());
  if (declaration.find('(') == std::string::npos && std::regex_search(declaration, match, classes)) {
    add(Definition::Kind::class_, match[1].str(), visible, end);
    scope(open + 1);  // classes inside it
  } else if (std::regex_search(declaration, match, members)) {
    add(Definition::Kind::member, match[1].str(), visible, end);
  }
  return end;
}

void Scanner::add(Definition::Kind kind, const std::string& of, std::size_t begin, std::size_t end) {
  found_.push_back({kind, of, line(begin), line(end - 1)});
}

void Scanner::blank_directives() {
  bool directive = false, line_begins = true;
  for (std::size_t i = 0; i < code_.size(); ++i) {
    const char c = code_[i];
    if (c == '\n') {
      if (i == 0 || code_[i - 1] != '\\') directive = false;
      line_begins = true;
      continue;
    }
    if (line_begins && c == '#') directive = true;
    if (c != ' ') line_begins = false;
    if (directive && c != '\\') code_[i] = ' ';
  }
}

/// The class that a member function of this name in `source` belongs to; null if the library defines none.
ClassLength* owner(std::vector<ClassLength>& classes, const Source& source, const std::string& name) {
  ClassLength* best = nullptr;
  int best_rank = 0;
  for (ClassLength& each : classes) {
    if (each.name != name) continue;
    const Source place = placed(each.path);
    const bool header = each.path.ends_with(".hpp");
    const int rank = each.path == source.path               ? 3
                     : !header || place.room != source.room ? 0
                     : place.floor == source.floor          ? 2
                                                            : 1;
    if (rank > best_rank) {
      best = &each;
      best_rank = rank;
    }
  }
  return best;
}

}  // namespace

std::vector<Definition> definitions(const std::string& code) { return Scanner(code).run(); }

std::vector<ClassLength> class_lengths(const std::vector<Source>& sources) {
  std::vector<ClassLength> classes;
  std::vector<std::pair<const Source*, Definition>> members;
  for (const Source& source : sources)
    for (const Definition& each : definitions(code_only(source))) {
      if (each.kind == Definition::Kind::class_) {
        classes.push_back({each.of, source.path, each.lines()});
      } else {
        members.emplace_back(&source, each);
      }
    }
  for (const auto& [source, member] : members)
    if (ClassLength* const of = owner(classes, *source, member.of)) of->lines += member.lines();
  return classes;
}

}  // namespace gapcheck::architecture_test
