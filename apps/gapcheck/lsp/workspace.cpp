#include "lsp/workspace.hpp"

#include <algorithm>
#include <utility>

#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

/// How much text of files that are not open is kept.
constexpr std::size_t most_disk_bytes = std::size_t{500} << 20;

}  // namespace

Document& Workspace::open(const std::string& uri, std::int64_t version, std::string_view text) {
  const std::string path = canonical(path_of(uri));
  auto& document = documents_[path];
  document = std::make_unique<Document>();
  document->uri = uri;
  document->path = path;
  document->version = version;
  set_text(*document, Text(text));
  return *document;
}

void Workspace::close(const std::string& uri) { documents_.erase(canonical(path_of(uri))); }

Document* Workspace::find(const std::string& uri) {
  const std::string path = path_of(uri);
  return path.empty() ? nullptr : find_path(canonical(path));
}

Document* Workspace::find_path(const std::string& path) {
  const auto found = documents_.find(path);
  return found == documents_.end() ? nullptr : found->second.get();
}

const Document* Workspace::find_path(const std::string& path) const {
  const auto found = documents_.find(path);
  return found == documents_.end() ? nullptr : found->second.get();
}

void Workspace::set_text(Document& document, Text text) {
  document.text = std::make_shared<const Text>(std::move(text));
  document.outline = std::make_shared<const std::vector<Keyword>>(outline(*document.text));
  document.faults = document.check.check(*document.text);
}

void Workspace::move_findings(const Document& document, Place begin, Place end, std::uint32_t added) {
  // A line whose first character is behind the edit stays whole.
  const std::uint32_t first_behind = end.byte == 0 ? end.line : end.line + 1;
  for (auto& [main, files] : findings_) {
    const auto found = files.find(document.path);
    if (found == files.end()) continue;
    for (LineFinding& finding : found->second) {
      if (finding.line >= first_behind)
        finding.line = finding.line - (end.line - begin.line) + added;
      else if (finding.line > begin.line)
        finding.line = begin.line;
    }
  }
}

std::set<std::string> Workspace::set_deck(const std::string& main, std::shared_ptr<const keyword::Deck> deck) {
  std::set<std::string> lost;
  std::erase_if(main_, [&](const auto& file) {
    if (file.second != main) return false;
    if (documents_.contains(file.first)) lost.insert(file.first);
    return true;
  });
  decks_.erase(main);
  if (deck == nullptr) return lost;
  for (const keyword::SourceFile& file : deck->files()) {
    const std::string path = canonical(file.path);
    main_[path] = main;
    lost.erase(path);
  }
  decks_[main] = std::move(deck);
  return lost;
}

std::string Workspace::main_of(const Document& document) const {
  const auto found = main_.find(document.path);
  return found == main_.end() ? std::string() : found->second;
}

FileView Workspace::view(const std::string& path, const Scope& scope) {
  if (const Document* document = find_path(path)) return {path, document->text, document->outline, scope};
  auto bytes = FileBytes::begin(path);
  DiskText& disk = disk_[path];
  const bool stale = bytes && (disk.text == nullptr || !(disk.stamp == bytes.value().stamp()));
  if (!bytes || (stale && !bytes.value().load(bytes.value().size()).ok()))
    return {path, std::make_shared<const Text>(), std::make_shared<const std::vector<Keyword>>(), scope};
  if (stale) {
    if (disk.text != nullptr) disk_bytes_ -= disk.text->size();
    disk.stamp = bytes.value().stamp();
    disk.text = std::make_shared<const Text>(bytes.value().bytes());
    disk.outline = std::make_shared<const std::vector<Keyword>>(outline(*disk.text));
    disk_bytes_ += disk.text->size();
  }
  const FileView file{path, disk.text, disk.outline, scope};
  if (disk_bytes_ > most_disk_bytes) {
    disk_.clear();
    disk_bytes_ = 0;
  }
  return file;
}

DeckFiles Workspace::files(const Document& document) {
  DeckFiles files{{document.path, document.text, document.outline, Scope()}};
  const auto deck = decks_.find(main_of(document));
  if (deck == decks_.end()) return files;
  std::set<std::string> seen;
  for (std::uint32_t i = 0; i < deck->second->files().size(); ++i) {
    const std::string path = canonical(deck->second->files()[i].path);
    if (!seen.insert(path).second) continue;
    if (path == document.path)
      files.own.scope = Scope(deck->second, FileIndex(i));
    else
      files.others.push_back([this, path, whole = deck->second, i] { return view(path, Scope(whole, FileIndex(i))); });
  }
  return files;
}

std::set<std::string> Workspace::set_findings(const std::string& main, Audited audited) {
  std::set<std::string> paths;
  for (const auto& [path, list] : findings_[main]) paths.insert(path);
  for (const auto& [path, list] : audited.findings) paths.insert(path);
  if (audited.findings.empty())
    findings_.erase(main);
  else
    findings_[main] = std::move(audited.findings);
  return paths;
}

std::vector<LineFinding> Workspace::findings(const std::string& path) const {
  std::vector<LineFinding> list;
  std::set<std::pair<std::uint32_t, std::string>> said;
  const auto add = [&](const LineFinding& finding) {
    if (said.emplace(finding.line, finding.message).second) list.push_back(finding);
  };
  for (const auto& [main, files] : findings_)
    if (const auto found = files.find(path); found != files.end())
      for (const LineFinding& finding : found->second) add(finding);
  return list;
}

LinesAt Workspace::changeable(const ReadFile& file, std::span<const FixedLine> lines) const {
  const auto now = FileBytes::begin(file.path);
  if (!now || !(now.value().stamp() == file.stamp)) return {};
  const Document* document = find_path(file.path);
  if (document == nullptr) return {uri_of(file.path), false};
  const bool same = !document->changed && std::ranges::all_of(lines, [&](const FixedLine& line) {
    return document->text->line(line.line) == line.before;
  });
  return same ? LinesAt{document->uri, true} : LinesAt{};
}

std::map<std::string, std::string> Workspace::changed_texts() const {
  std::map<std::string, std::string> texts;
  for (const auto& [path, document] : documents_)
    if (document->changed) texts[path] = skeleton(*document->text, *document->outline);
  return texts;
}

std::set<std::string> Workspace::open_paths() const {
  std::set<std::string> paths;
  for (const auto& [path, document] : documents_) paths.insert(path);
  return paths;
}

}  // namespace gapcheck::app::lsp
