#include <fmt/format.h>

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
      auto deck = deck_for_editor(main, options_(main).read, changed);
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
      auto audited = audit_for_editor(deck, options_(deck), go_on);
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
    auto fixed = fix_for_editor(main, options_(main).read);
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
    if (document != nullptr && document->changed) {
      notify("window/showMessage", {{"type", 1}, {"message", "gapcheck fix: " + path + " has changed; save it first"}});
      return;
    }
    json list = json::array();
    for (const keyword::LineEdit& edit : edits) {
      constexpr std::uint32_t end_of_line = std::numeric_limits<std::int32_t>::max();
      const std::uint32_t line = edit.line - 1;
      const json range = document == nullptr ? json{{"start", {{"line", line}, {"character", 0}}},
                                                    {"end", {{"line", line}, {"character", end_of_line}}}}
                                             : range_in(document->text->line(line), line, 0,
                                                        document->text->line(line).size(), encoding_);
      list.push_back({{"range", range}, {"newText", edit.text}});
    }
    changes[document != nullptr ? document->uri : uri_of(path)] = std::move(list);
  }
  notify("window/logMessage", {{"type", 3}, {"message", "gapcheck fix " + fixed.summary}});
  if (changes.empty()) {
    notify("window/showMessage", {{"type", 3}, {"message", "gapcheck fix: no node can be moved"}});
    return;
  }
  write({{"jsonrpc", "2.0"},
         {"id", fmt::format("gapcheck-{}", ++requests_)},
         {"method", "workspace/applyEdit"},
         {"params", {{"label", "gapcheck fix"}, {"edit", {{"changes", std::move(changes)}}}}}});
}

}  // namespace gapcheck::app::lsp
