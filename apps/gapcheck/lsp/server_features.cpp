#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "lsp/server.hpp"

namespace gapcheck::app::lsp {

/// Asks about a document.
template <class Ask>
Answer Server::ask(const json& params, const Ask& ask) {
  const std::string& uri = text_of(member(params, {"textDocument", "uri"}));
  const Document* document = workspace_.find(uri);
  if (document == nullptr) return Failure::not_open(uri);
  const DeckFiles files = workspace_.files(*document);
  return ask(Question{files, encoding_}, *document);
}

/// Asks about a place in a document.
template <class Ask>
Answer Server::ask_at(const json& params, const Ask& ask_there) {
  return ask(params, [&](const Question& question, const Document&) -> Answer {
    Place place;
    if (!read_place(member(params, {"position"}), question.text(), encoding_, place))
      return Failure{Failure::invalid_params, "no position is given"};
    place.byte = static_cast<std::uint32_t>(std::min<std::size_t>(place.byte, question.text().line(place.line).size()));
    return ask_there(question, place);
  });
}

Answer Server::hover(const json& params, const Message&) {
  return ask_at(params, [](const Question& q, Place at) -> Answer { return lsp::hover(q, at); });
}

Answer Server::completion(const json& params, const Message&) {
  return ask_at(params, [](const Question& q, Place at) -> Answer { return lsp::completion(q, at); });
}

Answer Server::definition(const json& params, const Message&) {
  return ask_at(params, [](const Question& q, Place at) -> Answer { return lsp::definition(q, at); });
}

Answer Server::references(const json& params, const Message&) {
  const bool all = is_true(member(params, {"context", "includeDeclaration"}));
  return ask_at(params, [all](const Question& q, Place at) -> Answer { return lsp::references(q, at, all); });
}

Answer Server::prepare_rename(const json& params, const Message&) {
  return ask_at(params, [](const Question& q, Place at) -> Answer { return lsp::prepare_rename(q, at); });
}

Answer Server::rename(const json& params, const Message&) {
  const std::string& name = text_of(member(params, {"newName"}));
  const Document* document = workspace_.find(text_of(member(params, {"textDocument", "uri"})));
  // Later on, a deck that is read again for what has changed is good enough: its texts are those of the editor.
  if (document != nullptr && workspace_.main_of(*document).empty()) {
    const bool being_read = decks_wanted_.contains(document->path);
    return Failure{Failure::request_failed, being_read ? "the files of the deck are still being read; try again"
                                                       : "the files of the deck cannot be read; save one to try again"};
  }
  return ask_at(params, [&](const Question& q, Place at) -> Answer {
    auto edits = lsp::rename(q, at, name);
    if (!edits) return Failure{Failure::request_failed, edits.error().message};
    return std::move(edits).value();
  });
}

Answer Server::document_symbols(const json& params, const Message&) {
  return ask(params, [](const Question& q, const Document&) -> Answer { return lsp::document_symbols(q); });
}

Answer Server::folding_ranges(const json& params, const Message&) {
  return ask(params, [](const Question& q, const Document&) -> Answer { return lsp::folding_ranges(q); });
}

Answer Server::range_formatting(const json& params, const Message&) {
  return ask(params, [&](const Question& q, const Document&) -> Answer {
    Place begin, end;
    if (!read_place(member(params, {"range", "start"}), q.text(), encoding_, begin) ||
        !read_place(member(params, {"range", "end"}), q.text(), encoding_, end))
      return Failure{Failure::invalid_params, "no range is given"};
    // A range that ends at the start of a line does not have that line.
    return lsp::format_lines(q, begin.line, end.byte == 0 && end.line > begin.line ? end.line : end.line + 1);
  });
}

Answer Server::code_actions(const json& params, const Message&) {
  return ask(params, [&](const Question& q, const Document& document) -> Answer {
    Place begin, end;
    if (!read_place(member(params, {"range", "start"}), q.text(), encoding_, begin) ||
        !read_place(member(params, {"range", "end"}), q.text(), encoding_, end))
      return Failure{Failure::invalid_params, "no range is given"};
    const std::vector<LineFinding> findings = workspace_.findings(document.path);
    const std::uint32_t behind = std::max(begin, end).line + 1;
    json actions = lsp::code_actions(q, findings, begin.line, behind);
    for (json& repair : repairs_of(q, document, findings, begin.line, behind)) actions.push_back(std::move(repair));
    return actions;
  });
}

/// Repairs of the findings in the lines [first, behind), if the document is as it was audited.
json Server::repairs_of(const Question& question, const Document& document, const std::vector<LineFinding>& findings,
                        std::uint32_t first, std::uint32_t behind) const {
  const std::string main = workspace_.main_of(document);
  const auto listed = repairs_.find(main.empty() ? document.path : main);
  if (listed == repairs_.end() || !*listed->second) return json::array();
  const DeckRepairs& repairs = listed->second->value();
  const bool current = std::ranges::any_of(repairs.files, [&](const auto& file) {
    return file.second.path == document.path && !workspace_.changeable(file.second, {}).uri.empty();
  });
  if (!current) return json::array();
  return lsp::repair_actions(
      question, findings, first, behind, repairs,
      [this](const ReadFile& file, std::span<const FixedLine> lines) { return workspace_.changeable(file, lines); });
}

Answer Server::execute(const json& params, const Message&) {
  const std::string& command = text_of(member(params, {"command"}));
  if (command != "gapcheck.fix") return Failure{Failure::invalid_params, "there is no command \"" + command + "\""};
  const json& arguments = member(params, {"arguments"});
  const std::string uri = arguments.is_array() && !arguments.empty() ? text_of(arguments[0]) : std::string();
  const Document* document = workspace_.find(uri);
  if (document == nullptr) return Failure::not_open(uri);
  if (document->changed) return Failure{Failure::request_failed, "the document has changed; save it first"};
  const std::string main = workspace_.main_of(*document);
  fix(main.empty() ? document->path : main);
  return json();
}

}  // namespace gapcheck::app::lsp
