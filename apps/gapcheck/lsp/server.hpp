#pragma once
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "base/result.hpp"
#include "lsp/features/features.hpp"
#include "lsp/frames.hpp"
#include "lsp/inbox.hpp"
#include "lsp/main_deck.hpp"
#include "lsp/message.hpp"
#include "lsp/repair_job.hpp"
#include "lsp/worker.hpp"
#include "lsp/workspace.hpp"

namespace gapcheck::app::lsp {

/// Why a request has no result.
struct Failure {
  // Codes of JSON-RPC and of the protocol.
  static constexpr int parse_error = -32700, invalid_request = -32600, method_not_found = -32601,
                       invalid_params = -32602, internal_error = -32603, not_initialized = -32002,
                       request_cancelled = -32800, request_failed = -32803;
  static Failure not_open(const std::string& uri) {
    return {invalid_params, "the document \"" + uri + "\" is not open"};
  }
  int code;
  std::string message;
};
using Answer = Result<json, Failure>;

/// A language server on two descriptors. One thread reads messages, one answers them, and four work on decks in the
/// background: what the decks are, audits, repairs, corrections.
class Server {
 public:
  /// `options`: may be asked by several threads at a time.
  Server(int in, int out, OptionsOf options, std::string version);
  /// Until the client says exit or hangs up; 0 if it said shutdown before, else 1. Afterwards threads may still wait
  /// for the client or work on a deck: the process is to end, and the server is not to be destroyed before.
  [[nodiscard]] int run();

 private:
  enum class Phase : std::uint8_t { starting, ready, shut_down };
  /// A method of the protocol.
  struct Method {
    Answer (Server::*handle)(const json& params, const Message& message);
    bool notification = false;
  };
  static const std::map<std::string_view, Method>& methods();

  void read_messages(int in);
  [[nodiscard]] bool read_one(FrameReader& frames);
  void take(const Message& message);
  void answer(const json& id, const Answer& answer);
  void notify(const char* method, json params);
  void request(const char* method, json params);
  void write(const json& message);
  void cancel(const json& id);
  [[nodiscard]] bool cancelled(const json& id);

  // Lifecycle
  Answer initialize(const json& params, const Message&);
  Answer initialized(const json&, const Message&);
  Answer ignored(const json&, const Message&);
  Answer shutdown(const json&, const Message&);
  Answer end(const json&, const Message&);
  // Documents
  Answer did_open(const json& params, const Message& message);
  Answer did_change(const json& params, const Message& message);
  Answer did_save(const json& params, const Message&);
  Answer did_close(const json& params, const Message&);
  Answer did_change_watched_files(const json&, const Message&);
  // Features
  template <class Ask>
  Answer ask(const json& params, const Ask& ask);
  template <class Ask>
  Answer ask_at(const json& params, const Ask& ask);
  Answer hover(const json& params, const Message&);
  Answer completion(const json& params, const Message&);
  Answer definition(const json& params, const Message&);
  Answer references(const json& params, const Message&);
  Answer prepare_rename(const json& params, const Message&);
  Answer rename(const json& params, const Message&);
  Answer document_symbols(const json& params, const Message&);
  Answer folding_ranges(const json& params, const Message&);
  Answer range_formatting(const json& params, const Message&);
  Answer code_actions(const json& params, const Message&);
  Answer execute(const json& params, const Message&);
  [[nodiscard]] json repairs_of(const Question& question, const Document& document,
                                const std::vector<LineFinding>& findings, std::uint32_t first,
                                std::uint32_t behind) const;

  [[nodiscard]] bool apply(const json& change, const Message& message, Document& document);
  void publish(const std::string& path);
  /// Finds and reads the deck of a document in the background; then audits it, if that is asked for.
  void read_deck(const std::string& path, bool audit);
  using Deck = std::shared_ptr<const keyword::Deck>;
  [[nodiscard]] std::map<std::string, std::set<std::string>> by_deck(const std::set<std::string>& files,
                                                                     const std::vector<std::string>& folders,
                                                                     const std::set<std::string>& open,
                                                                     const Worker::GoOn& go_on);
  [[nodiscard]] Deck read_deck_file(const std::string& main, const std::map<std::string, std::string>& changed);
  void take_deck(const std::string& main, const std::set<std::string>& files, const Deck& deck);
  void audit(const std::string& main);
  void list_repairs(const std::string& main);
  void fix(const std::string& main);
  void apply_fix(const FixedLines& fixed);

  const int in_, out_;
  const OptionsOf options_;
  const std::string version_;
  Phase phase_ = Phase::starting;
  std::optional<int> code_;  ///< set: the server ends
  Encoding encoding_ = Encoding::utf16;
  bool watches_ = false;  ///< the client can watch files
  std::vector<std::string> folders_;
  Workspace workspace_;
  std::set<std::string> decks_wanted_;    ///< files whose deck is to be read
  std::set<std::string> audits_wanted_;   ///< of them those whose deck is to be audited then
  std::set<std::string> audits_running_;  ///< main files of decks that are audited or wait for it
  std::set<std::string> repairs_wanted_;  ///< main files of decks whose repairs are listed or wait for it
  std::map<std::string, std::shared_ptr<const Result<DeckRepairs>>> repairs_;  ///< by main file
  std::int64_t requests_ = 0;                                                  ///< of the server to the client
  std::mutex mutex_;
  std::map<std::string, bool> waiting_;  ///< requests by their id as JSON, and whether they are cancelled
  Inbox inbox_;
  MainDecks main_decks_;  ///< of the thread of `reader_` alone
  Worker reader_, auditor_, repairer_, fixer_;
};

}  // namespace gapcheck::app::lsp
