#include "lsp/server.hpp"

#include <fmt/format.h>

#include <exception>
#include <memory>
#include <thread>
#include <utility>

#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

/// What JSON-RPC takes for the id of a request.
bool is_id(const json& id) { return id.is_string() || id.is_number() || id.is_null(); }

/// nullptr: a message without an id, which is a notification.
const json* id_of(const json& message) {
  if (!message.is_object()) return nullptr;
  const auto found = message.find("id");
  return found == message.end() ? nullptr : &*found;
}

std::string dumped(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

}  // namespace

const std::map<std::string_view, Server::Method>& Server::methods() {
  static const std::map<std::string_view, Method> table{
      {"initialize", {&Server::initialize}},
      {"initialized", {&Server::initialized, true}},
      {"shutdown", {&Server::shutdown}},
      {"exit", {&Server::end, true}},
      {"$/setTrace", {&Server::ignored, true}},
      {"workspace/didChangeConfiguration", {&Server::ignored, true}},
      {"workspace/didChangeWatchedFiles", {&Server::did_change_watched_files, true}},
      {"workspace/executeCommand", {&Server::execute}},
      {"textDocument/didOpen", {&Server::did_open, true}},
      {"textDocument/didChange", {&Server::did_change, true}},
      {"textDocument/didSave", {&Server::did_save, true}},
      {"textDocument/didClose", {&Server::did_close, true}},
      {"textDocument/hover", {&Server::hover}},
      {"textDocument/completion", {&Server::completion}},
      {"textDocument/definition", {&Server::definition}},
      {"textDocument/references", {&Server::references}},
      {"textDocument/prepareRename", {&Server::prepare_rename}},
      {"textDocument/rename", {&Server::rename}},
      {"textDocument/documentSymbol", {&Server::document_symbols}},
      {"textDocument/foldingRange", {&Server::folding_ranges}},
      {"textDocument/rangeFormatting", {&Server::range_formatting}},
      {"textDocument/codeAction", {&Server::code_actions}},
  };
  return table;
}

Server::Server(int in, int out, OptionsOf options, std::string version)
    : in_(in), out_(out), options_(std::move(options)), version_(std::move(version)) {}

int Server::run() {
  // It may wait for a client that neither writes nor hangs up.
  std::thread([this] { read_messages(in_); }).detach();
  while (!code_) inbox_.next()();
  return *code_;
}

void Server::read_messages(int in) {
  enlarge_pipe(in);
  FrameReader frames(in);
  try {
    while (read_one(frames)) continue;
  } catch (const std::exception& error) {  // too little memory for a message: where the next one begins is lost
    inbox_.post([this, text = std::string(error.what())] {
      answer(nullptr, Failure{Failure::internal_error, text});
      code_ = 1;
    });
  }
}

/// False: there is nothing more to read.
bool Server::read_one(FrameReader& frames) {
  Frame frame = frames.next();
  if (frame.kind != Frame::Kind::message) {
    const bool last = frame.kind != Frame::Kind::refused;
    inbox_.post([this, text = frame.text, last] {
      if (!text.empty()) answer(nullptr, Failure{Failure::parse_error, text});
      if (last && !code_) code_ = phase_ == Phase::shut_down ? 0 : 1;
    });
    return !last;
  }
  const auto message = std::make_shared<Message>(read_message(std::move(frame.text)));
  const std::string& method = text_of(member(message->value, {"method"}));
  const json* const id = id_of(message->value);
  // Requests of these names are answered with an error and do nothing.
  if (method == "$/cancelRequest" && id == nullptr) {
    cancel(member(message->value, {"params", "id"}));
    return true;
  }
  const bool last = method == "exit" && id == nullptr;
  if (id != nullptr && is_id(*id) && !method.empty()) {
    const std::lock_guard lock(mutex_);
    waiting_[dumped(*id)] = false;
  }
  inbox_.post([this, message] { take(*message); }, true);
  return !last;
}

/// What is answered already is not cancelled: the client may give its id to another request.
void Server::cancel(const json& id) {
  const std::lock_guard lock(mutex_);
  if (const auto waits = waiting_.find(dumped(id)); waits != waiting_.end()) waits->second = true;
}

bool Server::cancelled(const json& id) {
  const std::lock_guard lock(mutex_);
  const auto request = waiting_.extract(dumped(id));
  return !request.empty() && request.mapped();
}

void Server::take(const Message& message) {
  if (code_) return;
  if (message.value.is_discarded()) return answer(nullptr, Failure{Failure::parse_error, message.wrong});
  const json* const given = id_of(message.value);
  const bool request = given != nullptr;
  const json id = request ? *given : json();
  const json& method = member(message.value, {"method"});
  if (!is_id(id)) return answer(nullptr, Failure{Failure::invalid_request, "an id is a number, a text or null"});
  if (!method.is_string()) {
    // What the client says about a request of the server.
    if (request && !message.value.contains("method")) return;
    return answer(id, Failure{Failure::invalid_request, "the message names no method"});
  }
  const std::string& name = text_of(method);
  const bool is_cancelled = request && cancelled(id);
  const auto found = methods().find(name);
  if (found == methods().end()) {
    // Others of the optional ones may be ignored.
    if (request) answer(id, Failure{Failure::method_not_found, "gapcheck does not know the method \"" + name + "\""});
    return;
  }
  if (request == found->second.notification) {
    if (request) answer(id, Failure{Failure::invalid_request, name + " is a notification"});
    return;
  }
  if (phase_ == Phase::starting && name != "initialize" && name != "exit") {
    if (request) answer(id, Failure{Failure::not_initialized, "the client has not said initialize"});
    return;
  }
  if (phase_ == Phase::shut_down && name != "exit") {
    if (request) answer(id, Failure{Failure::invalid_request, "the client has said shutdown"});
    return;
  }
  if (is_cancelled) return answer(id, Failure{Failure::request_cancelled, "cancelled"});
  try {
    const Answer result = (this->*found->second.handle)(member(message.value, {"params"}), message);
    if (request) answer(id, result);
  } catch (const std::exception& error) {  // too little memory
    if (request) answer(id, Failure{Failure::internal_error, error.what()});
  }
}

void Server::answer(const json& id, const Answer& answer) {
  json message{{"jsonrpc", "2.0"}, {"id", id}};
  if (answer)
    message["result"] = answer.value();
  else
    message["error"] = {{"code", answer.error().code}, {"message", answer.error().message}};
  write(message);
}

void Server::notify(const char* method, json params) {
  write({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

void Server::request(const char* method, json params) {
  const std::string id = fmt::format("gapcheck-{}", ++requests_);
  write({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(params)}});
}

void Server::write(const json& message) {
  if (!write_frame(out_, dumped(message)) && !code_) code_ = 1;
}

Answer Server::initialize(const json& params, const Message&) {
  if (phase_ != Phase::starting) return Failure{Failure::invalid_request, "the client has said initialize before"};
  phase_ = Phase::ready;
  for (const json& each : member(params, {"capabilities", "general", "positionEncodings"}))
    if (text_of(each) == "utf-8") encoding_ = Encoding::utf8;
  watches_ = is_true(member(params, {"capabilities", "workspace", "didChangeWatchedFiles", "dynamicRegistration"}));
  for (const json& each : member(params, {"workspaceFolders"}))
    if (const std::string folder = path_of(text_of(member(each, {"uri"}))); !folder.empty()) folders_.push_back(folder);
  if (folders_.empty())
    if (const std::string root = path_of(text_of(member(params, {"rootUri"}))); !root.empty()) folders_ = {root};
  const json sync{{"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}};
  const json capabilities{{"positionEncoding", encoding_ == Encoding::utf8 ? "utf-8" : "utf-16"},
                          {"textDocumentSync", sync},
                          {"hoverProvider", true},
                          {"completionProvider", {{"triggerCharacters", {"*", "_"}}}},
                          {"definitionProvider", true},
                          {"referencesProvider", true},
                          {"documentSymbolProvider", true},
                          {"foldingRangeProvider", true},
                          {"documentRangeFormattingProvider", true},
                          {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
                          {"renameProvider", {{"prepareProvider", true}}},
                          {"executeCommandProvider", {{"commands", {"gapcheck.fix"}}}}};
  return json{{"capabilities", capabilities}, {"serverInfo", {{"name", "gapcheck"}, {"version", version_}}}};
}

/// Has the client watch settings files: editors do not open them as decks.
Answer Server::initialized(const json&, const Message&) {
  if (!watches_) return json();
  const json watchers{{"watchers", json::array({{{"globPattern", "**/gapcheck.toml"}}})}};
  request("client/registerCapability", {{"registrations", json::array({{{"id", "settings"},
                                                                        {"method", "workspace/didChangeWatchedFiles"},
                                                                        {"registerOptions", watchers}}})}});
  return json();
}

Answer Server::ignored(const json&, const Message&) { return json(); }

Answer Server::shutdown(const json&, const Message&) {
  phase_ = Phase::shut_down;
  return json();
}

Answer Server::end(const json&, const Message&) {
  code_ = phase_ == Phase::shut_down ? 0 : 1;
  return json();
}

}  // namespace gapcheck::app::lsp
