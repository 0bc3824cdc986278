#include <algorithm>
#include <limits>
#include <utility>

#include "lsp/server.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {

void Server::read_deck(const std::string& path, bool audit) {
  decks_wanted_.insert(path);
  if (audit) audits_wanted_.insert(path);
  reader_.start([this, wanted = decks_wanted_, folders = folders_, open = workspace_.open_paths(),
                 changed = workspace_.changed_texts()](const Worker::GoOn& go_on) {
    main_decks_.scan(folders, go_on);
    for (const std::string& file : wanted) {
      if (!go_on()) return;
      const std::string main = main_decks_.main_of(file, open);
      auto deck = deck_for_editor(main, options_(main).audit.read, changed);
      inbox_.post([this, file, main, deck = std::move(deck)] {
        decks_wanted_.erase(file);
        if (deck != nullptr) workspace_.set_deck(main, deck);
        if (audits_wanted_.erase(file) > 0) this->audit(main);
      });
    }
  });
}

void Server::audit(const std::string& main) {
  // The newest first; what was running begins again after it.
  std::vector<std::string> mains{main};
  audits_running_.erase(main);
  mains.insert(mains.end(), audits_running_.begin(), audits_running_.end());
  audits_running_.insert(main);
  auditor_.start([this, mains](const Worker::GoOn& go_on) {
    for (const std::string& deck : mains) {
      auto audited = audit_for_editor(deck, options_, go_on);
      if (!audited) return;
      inbox_.post([this, deck, result = std::move(*audited)] {
        audits_running_.erase(deck);
        notify("window/logMessage", {{"type", 3}, {"message", "gapcheck audit " + result.summary}});
        for (const std::string& path : workspace_.set_findings(deck, result)) publish(path);
      });
    }
  });
}

void Server::fix(const std::string& main) {
  fixer_.start([this, main](const Worker::GoOn& go_on) {
    auto fixed = fix_for_editor(main, options_);
    if (!go_on()) return;
    inbox_.post([this, fixed = std::move(fixed)] {
      if (!fixed)
        notify("window/showMessage", {{"type", 1}, {"message", "gapcheck fix: " + fixed.error().message}});
      else
        apply_fix(fixed.value());
    });
  });
}

void Server::apply_fix(const FixedLines& fixed) {
  json changes = json::object();
  for (const auto& [path, edits] : fixed.edits) {
    const Document* document = workspace_.find_path(path);
    // Another program may have written the file.
    const auto other_line = [&](const FixedLine& edit) { return document->text->line(edit.line) != edit.before; };
    if (document != nullptr && (document->changed || std::ranges::any_of(edits, other_line))) {
      notify("window/showMessage", {{"type", 1}, {"message", "gapcheck fix: " + path + " has changed; save it first"}});
      return;
    }
    json list = json::array();
    for (const FixedLine& edit : edits) {
      constexpr std::uint32_t end_of_line = std::numeric_limits<std::int32_t>::max();
      json range = lines_range(edit.line, edit.line);
      range["end"]["character"] = end_of_line;
      if (document != nullptr) range = range_in(edit.before, edit.line, 0, edit.before.size(), encoding_);
      list.push_back({{"range", std::move(range)}, {"newText", edit.after}});
    }
    changes[document != nullptr ? document->uri : uri_of(path)] = std::move(list);
  }
  notify("window/logMessage", {{"type", 3}, {"message", "gapcheck fix " + fixed.summary}});
  if (changes.empty()) {
    notify("window/showMessage", {{"type", 3}, {"message", "gapcheck fix: no node can be moved"}});
    return;
  }
  request("workspace/applyEdit", {{"label", "gapcheck fix"}, {"edit", {{"changes", std::move(changes)}}}});
}

}  // namespace gapcheck::app::lsp
