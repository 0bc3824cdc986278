#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "base/file_bytes.hpp"
#include "lsp/server.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

/// Severities of the protocol.
constexpr int hint = 4;
int level_of(Severity severity) { return severity == Severity::error ? 1 : severity == Severity::warning ? 2 : 3; }

}  // namespace

Answer Server::did_open(const json& params, const Message& message) {
  const std::string& uri = text_of(member(params, {"textDocument", "uri"}));
  const json& text = member(params, {"textDocument", "text"});
  if (path_of(uri).empty() || !text.is_string()) return json();
  Document& document = workspace_.open(uri, count_of(member(params, {"textDocument", "version"})), message.text(text));
  // A text from the editor's memory of unsaved files: lines of the file are not those of the text.
  const auto on_disk = FileBytes::open(document.path);
  document.changed = !on_disk || on_disk.value().bytes() != message.text(text);
  if (folders_.empty()) folders_ = {document.path.substr(0, document.path.rfind('/') + 1)};
  publish(document.path);
  read_deck(document.path, true);
  return json();
}

bool Server::apply(const json& change, const Message& message, Document& document) {
  const json &text = member(change, {"text"}), &range = member(change, {"range"});
  if (!text.is_string()) return false;
  if (range.is_null()) {
    Workspace::set_text(document, Text(message.text(text)));
    return true;
  }
  Place begin, end;
  if (!read_place(member(range, {"start"}), *document.text, encoding_, begin) ||
      !read_place(member(range, {"end"}), *document.text, encoding_, end))
    return false;
  end = std::max(begin, end);
  const std::string& replacement = message.text(text);
  const Keyword* const before = keyword_at(*document.outline, begin.line);
  const bool structure = before != nullptr && is_structure(*before);
  const std::size_t keywords = document.outline->size();
  Workspace::set_text(document, document.text->edited(begin, end, replacement));
  const auto added = static_cast<std::uint32_t>(std::count(replacement.begin(), replacement.end(), '\n'));
  workspace_.move_findings(document, begin, end, added);
  const Keyword* const after = keyword_at(*document.outline, begin.line);
  return structure || (after != nullptr && is_structure(*after)) || keywords != document.outline->size();
}

Answer Server::did_change(const json& params, const Message& message) {
  Document* document = workspace_.find(text_of(member(params, {"textDocument", "uri"})));
  if (document == nullptr) return json();
  document->version = count_of(member(params, {"textDocument", "version"}));
  document->changed = true;
  bool structure = false;
  for (const json& change : member(params, {"contentChanges"})) structure |= apply(change, message, *document);
  publish(document->path);
  if (structure) read_deck(document->path, false);
  return json();
}

Answer Server::did_save(const json& params, const Message&) {
  Document* document = workspace_.find(text_of(member(params, {"textDocument", "uri"})));
  if (document == nullptr) return json();
  document->changed = false;
  read_deck(document->path, true);
  return json();
}

Answer Server::did_close(const json& params, const Message&) {
  const std::string& uri = text_of(member(params, {"textDocument", "uri"}));
  Document* document = workspace_.find(uri);
  if (document == nullptr) return json();
  const std::string path = document->path;
  const bool changed = document->changed;
  workspace_.close(uri);
  // Nothing is found in a file that there is not, such as one that was never saved.
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown))
    for (const std::string& each : workspace_.set_findings(path, {})) publish(each);
  publish(path);
  // Its file counts again.
  if (changed) read_deck(path, false);
  return json();
}

/// Of settings: they are read with each audit.
Answer Server::did_change_watched_files(const json&, const Message&) {
  for (const std::string& path : workspace_.open_paths()) read_deck(path, true);
  return json();
}

void Server::publish(const std::string& path) {
  const Document* document = workspace_.find_path(path);
  json list = json::array();
  std::set<std::pair<std::uint32_t, std::string>> said;
  const auto add = [&](json range, int level, const std::string& code, const std::string& message) {
    if (!said.emplace(range["start"]["line"].get<std::uint32_t>(), message).second) return;
    json each{{"range", std::move(range)}, {"severity", level}, {"source", "gapcheck"}, {"message", message}};
    if (!code.empty()) each["code"] = code;
    list.push_back(std::move(each));
  };
  // What both say is told as the rule says it.
  for (const LineFinding& finding : workspace_.findings(path)) {
    json range = lines_range(finding.line, finding.line + 1);
    if (document != nullptr) {
      const std::uint32_t at = std::min(finding.line, document->text->lines() - 1);
      const std::string_view line = document->text->line(at);
      range = range_in(line, at, 0, line.size(), encoding_);
    }
    if (finding.known)
      add(std::move(range), hint, finding.code, "known: " + finding.message);
    else
      add(std::move(range), level_of(finding.severity), finding.code, finding.message);
  }
  if (document != nullptr)
    for (const LineFault& fault : document->faults)
      add(range_in(document->text->line(fault.line), fault.line, fault.begin, fault.end, encoding_),
          level_of(fault.severity), {}, fault.message);
  json params{{"uri", document != nullptr ? document->uri : uri_of(path)}, {"diagnostics", std::move(list)}};
  if (document != nullptr) params["version"] = document->version;
  notify("textDocument/publishDiagnostics", std::move(params));
}

}  // namespace gapcheck::app::lsp
