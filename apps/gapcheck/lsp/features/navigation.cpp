#include <algorithm>

#include "lsp/features/features.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

constexpr std::size_t most_references = 10'000;

}  // namespace

json location_of(const FileView& file, const Occurrence& at, Encoding encoding) {
  return {{"uri", uri_of(file.path)},
          {"range", range_in(file.text->line(at.line), at.line, at.begin, at.end, encoding)}};
}

std::optional<FoundDefinition> find_definition(const DeckFiles& deck, const Symbol& symbol) {
  std::optional<FoundDefinition> found;
  deck.for_each([&](const FileView& file) {
    for_each_occurrence(file, symbol, Reach::definitions, [&](const Occurrence& at) {
      if (at.definition) found = FoundDefinition{file, at, {}};
      return !found;
    });
    return !found;
  });
  if (!found || symbol.kind == Kind::node || symbol.kind == Kind::element) return found;
  if (const Keyword* keyword = keyword_at(*found->file.outline, found->at.line))
    for (const Defined& each : definitions_in(found->file, *keyword))
      if (each.at.line == found->at.line) found->title = each.title;
  return found;
}

std::string included_file(const FileView& file, std::uint32_t line) {
  if (!file.scope.whole()) return {};
  const auto files = file.scope.deck().files();
  const std::string own = canonical(file.path);
  for (const keyword::SourceFile& each : files)
    if (each.includer != none<FileIndex> && each.include_line == line + 1 &&
        canonical(file.scope.deck().file(each.includer).path) == own)
      return canonical(each.path);
  return {};
}

json definition(const Question& question, Place place) {
  if (const std::string file = included_file(question.file(), place.line); !file.empty())
    return {{"uri", uri_of(file)}, {"range", lines_range(0, 0)}};
  const auto at = occurrence_at(question.file(), place);
  if (!at) return nullptr;
  const auto found = find_definition(question.deck, at->symbol);
  return found ? location_of(found->file, found->at, question.encoding) : json();
}

json references(const Question& question, Place place, bool with_definition) {
  const auto at = occurrence_at(question.file(), place);
  if (!at) return nullptr;
  const bool of_mesh = at->symbol.kind == Kind::node || at->symbol.kind == Kind::element;
  json list = json::array();
  question.deck.for_each([&](const FileView& file) {
    for_each_occurrence(file, at->symbol, of_mesh ? Reach::everything : Reach::cards, [&](const Occurrence& each) {
      if (with_definition || !each.definition) list.push_back(location_of(file, each, question.encoding));
      return list.size() < most_references;
    });
    return list.size() < most_references;
  });
  return list;
}

}  // namespace gapcheck::app::lsp
