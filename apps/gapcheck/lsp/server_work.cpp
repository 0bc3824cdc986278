#include <algorithm>
#include <exception>
#include <utility>

#include "lsp/server.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

bool has_file(const keyword::Deck& deck, const std::string& path) {
  return std::ranges::any_of(deck.files(),
                             [&](const keyword::SourceFile& file) { return canonical(file.path) == path; });
}

}  // namespace

void Server::read_deck(const std::string& path, bool audit) {
  decks_wanted_.insert(path);
  if (audit) audits_wanted_.insert(path);
  // What has been read when a newer job begins is read again by that one.
  reader_.start([this, wanted = decks_wanted_, folders = folders_, open = workspace_.open_paths(),
                 changed = workspace_.changed_texts()](const Worker::GoOn& go_on) {
    const auto post = [&](const std::string& main, const std::set<std::string>& files, Deck deck) {
      inbox_.post([this, go_on, main, files, deck = std::move(deck)] {
        if (go_on()) take_deck(main, files, deck);
      });
    };
    for (auto& [main, files] : by_deck(wanted, folders, open, go_on)) {
      if (!go_on()) return;
      const Deck deck = read_deck_file(main, changed);
      // The editor may have a text of the deck that does not include the file any more.
      for (const std::string& file : files)
        if (deck != nullptr && !has_file(*deck, file)) post(file, {}, read_deck_file(file, changed));
      post(main, files, deck);
    }
  });
}

/// Main files of decks, and which of the files belong to each.
std::map<std::string, std::set<std::string>> Server::by_deck(const std::set<std::string>& files,
                                                             const std::vector<std::string>& folders,
                                                             const std::set<std::string>& open,
                                                             const Worker::GoOn& go_on) try {
  std::map<std::string, std::set<std::string>> decks;
  main_decks_.scan(folders, go_on);
  for (const std::string& file : files) decks[main_decks_.main_of(file, open)].insert(file);
  return decks;
} catch (const std::exception&) {  // too little memory
  std::map<std::string, std::set<std::string>> decks;
  for (const std::string& file : files) decks[file].insert(file);
  return decks;
}

/// nullptr: it cannot be read.
Server::Deck Server::read_deck_file(const std::string& main, const std::map<std::string, std::string>& changed) try {
  return deck_for_editor(main, options_(main).audit.read, changed);
} catch (const std::exception&) {  // too little memory
  return nullptr;
}

/// Takes a deck that was read for some of its files.
void Server::take_deck(const std::string& main, const std::set<std::string>& files, const Deck& deck) {
  bool audits = false;
  for (const std::string& file : files) {
    decks_wanted_.erase(file);
    audits = audits_wanted_.erase(file) > 0 || audits;
    // What was found when the file still was a deck of its own.
    if (file != main)
      for (const std::string& path : workspace_.set_findings(file, {})) publish(path);
  }
  for (const std::string& path : workspace_.set_deck(main, deck))
    if (deck != nullptr && !files.contains(path)) read_deck(path, false);
  if (audits) audit(main);
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
      inbox_.post([this, go_on, deck, result = std::move(*audited)] {
        if (!go_on()) return;  // a newer job has this deck, too
        audits_running_.erase(deck);
        notify("window/logMessage", {{"type", 3}, {"message", "gapcheck audit " + result.summary}});
        for (const std::string& path : workspace_.set_findings(deck, result)) publish(path);
        if (result.repairable)
          list_repairs(deck);
        else
          repairs_.erase(deck);
      });
    }
  });
}

/// What repairs of cards would write, for code actions.
void Server::list_repairs(const std::string& main) {
  repairs_wanted_.insert(main);
  repairer_.start([this, mains = repairs_wanted_](const Worker::GoOn& go_on) {
    for (const std::string& deck : mains) {
      const auto listed = std::make_shared<const Result<DeckRepairs>>(repairs_for_editor(deck, options_));
      if (!go_on()) return;
      inbox_.post([this, go_on, deck, listed] {
        if (!go_on()) return;  // a newer job has this deck, too
        repairs_wanted_.erase(deck);
        repairs_[deck] = listed;
        const std::string said = *listed ? listed->value().summary : deck + ": no repairs: " + listed->error().message;
        notify("window/logMessage", {{"type", 3}, {"message", "gapcheck fix " + said}});
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
    const bool open = document != nullptr;
    changes[open ? document->uri : uri_of(path)] = line_edits(edits, encoding_, open);
  }
  notify("window/logMessage", {{"type", 3}, {"message", "gapcheck fix " + fixed.summary}});
  if (changes.empty()) {
    notify("window/showMessage", {{"type", 3}, {"message", "gapcheck fix: no node can be moved"}});
    return;
  }
  request("workspace/applyEdit", {{"label", "gapcheck fix"}, {"edit", {{"changes", std::move(changes)}}}});
}

}  // namespace gapcheck::app::lsp
