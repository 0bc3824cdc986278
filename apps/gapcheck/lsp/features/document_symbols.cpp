#include <fmt/format.h>

#include "base/number.hpp"
#include "lsp/features/features.hpp"

namespace gapcheck::app::lsp {
namespace {

constexpr std::size_t most_symbols = 20'000;

// Numbers of the protocol.
constexpr int kind_namespace = 3, kind_field = 8, kind_number = 16;

/// Behind the last line of a keyword that is not blank.
std::uint32_t end_of(const Text& text, const Keyword& keyword) {
  std::uint32_t end = keyword.end;
  while (end > keyword.line + 1 && trimmed(text.line(end - 1)).empty()) --end;
  return end;
}

json symbol(const Text& text, std::string name, std::string detail, int kind, std::uint32_t line, std::uint32_t end,
            Encoding encoding) {
  const std::string_view own = text.line(line);
  const json selection = range_in(own, line, 0, own.size(), encoding);
  json range = selection;
  if (end > line + 1) {
    const std::string_view last = text.line(end - 1);
    range["end"] = range_in(last, end - 1, 0, last.size(), encoding)["end"];
  }
  json result{{"name", std::move(name)}, {"kind", kind}, {"range", range}, {"selectionRange", selection}};
  if (!detail.empty()) result["detail"] = std::move(detail);
  return result;
}

}  // namespace

json document_symbols(const Question& question) {
  json list = json::array();
  std::size_t count = 0;
  const Text& text = question.text();
  for (const Keyword& keyword : *question.file().outline) {
    if (++count > most_symbols) break;
    const std::uint32_t end = end_of(text, keyword);
    json each = symbol(text, "*" + keyword.name, "", kind_namespace, keyword.line, end, question.encoding);
    json children = json::array();
    for (const Defined& defined : definitions_in(question.file(), keyword)) {
      if (++count > most_symbols) break;
      const Symbol& what = defined.at.symbol;
      const bool parameter = what.kind == Kind::parameter;
      std::string name = parameter ? what.name : fmt::format("{} {}", name_of(what.kind), what.id);
      children.push_back(symbol(text, std::move(name), defined.title, parameter ? kind_field : kind_number,
                                defined.at.line, defined.at.line + 1, question.encoding));
    }
    if (children.size() == 1)
      each["detail"] = children[0]["name"].get<std::string>() +
                       (children[0].contains("detail") ? " " + children[0]["detail"].get<std::string>() : "");
    if (!children.empty()) each["children"] = std::move(children);
    list.push_back(std::move(each));
  }
  return list;
}

json folding_ranges(const Question& question) {
  json list = json::array();
  for (const Keyword& keyword : *question.file().outline) {
    if (list.size() == most_symbols) break;
    const std::uint32_t end = end_of(question.text(), keyword);
    if (end > keyword.line + 1) list.push_back({{"startLine", keyword.line}, {"endLine", end - 1}, {"kind", "region"}});
  }
  return list;
}

}  // namespace gapcheck::app::lsp
