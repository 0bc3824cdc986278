#include "lsp/server.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "folder_test.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {
namespace {

constexpr const char* deck_text = "*KEYWORD\n*INCLUDE\nmesh.k\n*PART\nplate\n         1         1         1\n*END\n";
constexpr const char* mesh_text = "*ELEMENT_SHELL\n       1       1       1       2       3       4\n";

/// A server in this process, with its threads, and an editor that speaks with it. A test may say what the options of
/// decks are, and when they are known.
class LspServer : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    write("main.k", deck_text);
    write("mesh.k", mesh_text);
    ASSERT_EQ(::pipe(to_.data()), 0);
    ASSERT_EQ(::pipe(from_.data()), 0);
    reader_.emplace(from_[0]);
    // Its threads go on for ever, so that it is not to be destroyed.
    static auto* const kept = new std::vector<Server*>();
    auto* const server = new Server(
        to_[0], from_[1], [options = options_](const std::string& deck) { return (*options)(deck); }, "1");
    kept->push_back(server);
    running_ = std::async(std::launch::async, [server] { return server->run(); });
    // A message that does not come is not waited for without end.
    watch_ = std::async(std::launch::async, [end = from_[1], done = done_.get_future().share()] {
      std::chrono::seconds limit(20);
      for (; done.wait_for(limit) == std::future_status::timeout; limit = std::chrono::seconds(1))
        static_cast<void>(write_frame(end, R"({"method": "nothing more"})"));
    });
    const json watches{{"workspace", {{"didChangeWatchedFiles", {{"dynamicRegistration", true}}}}}};
    request("initialize", {{"rootUri", uri_of(folder_.string())}, {"capabilities", watches}});
    notify("initialized", json::object());
  }
  void TearDown() override {
    request("shutdown");
    notify("exit", json::object());
    EXPECT_EQ(running_.get(), 0);
    done_.set_value();
    FolderTest::TearDown();
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string uri(const std::string& name) const { return uri_of(canonical((folder_ / name).string())); }

  void send(const json& message) { ASSERT_TRUE(write_frame(to_[1], message.dump())); }
  void notify(const char* method, const json& params) { send({{"method", method}, {"params", params}}); }
  /// The next message that fits; what the server publishes on the way is kept.
  template <class Wanted>
  json wait(const Wanted& wanted) {
    for (;;) {
      const Frame frame = reader_->next();
      json message = json::parse(frame.text, nullptr, false);
      if (message.is_discarded() || message.value("method", "") == "nothing more")
        return ADD_FAILURE() << "no such message comes", json();
      if (message.value("method", "") == "textDocument/publishDiagnostics")
        published_[message["params"]["uri"]] = message["params"]["diagnostics"];
      if (wanted(message)) return message;
    }
  }
  json answer_to(const json& id) {
    return wait([&](const json& m) { return !m.contains("method") && m["id"] == id; });
  }
  json request(const char* method, const json& params = json::object()) {
    send({{"id", ++requests_}, {"method", method}, {"params", params}});
    return answer_to(requests_);
  }
  /// Waits for the end of an audit, and for what it publishes.
  std::string audited() {
    const json said = wait([](const json& m) { return m.value("method", "") == "window/logMessage"; });
    static_cast<void>(request("no/such"));
    return said["params"]["message"];
  }
  void open(const std::string& name, const std::string& text) {
    notify("textDocument/didOpen", {{"textDocument", {{"uri", uri(name)}, {"version", 1}, {"text", text}}}});
  }
  void save(const std::string& name) { notify("textDocument/didSave", {{"textDocument", {{"uri", uri(name)}}}}); }
  void change(const std::string& name, const std::string& text) {
    notify("textDocument/didChange", {{"textDocument", {{"uri", uri(name)}, {"version", 2}}},
                                      {"contentChanges", json::array({{{"text", text}}})}});
  }
  /// Renames the part of mesh.k's element: why it is refused, or how many files change.
  std::string renamed() {
    const json said = request(
        "textDocument/rename",
        {{"textDocument", {{"uri", uri("mesh.k")}}}, {"position", {{"line", 1}, {"character", 15}}}, {"newName", "7"}});
    if (said.contains("error")) return said["error"]["message"];
    return std::to_string(said["result"]["changes"].size()) + " files";
  }
  /// The same, again until it is that.
  void expect_renamed(const std::string& expected) {
    std::string now = renamed();
    for (int i = 0; i < 1000 && now != expected; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      now = renamed();
    }
    EXPECT_EQ(now, expected);
  }
  /// Whether the editor shows a diagnostic with that message for a file.
  bool shows(const std::string& name, const std::string& message) {
    return std::ranges::any_of(published_[uri(name)], [&](const json& each) { return each["message"] == message; });
  }

  std::shared_ptr<OptionsOf> options_ = std::make_shared<OptionsOf>([](const std::string&) { return DeckOptions(); });
  std::map<std::string, json> published_;

 private:
  std::array<int, 2> to_{}, from_{};
  std::future<int> running_;
  std::future<void> watch_;
  std::promise<void> done_;
  std::int64_t requests_ = 0;
  std::optional<FrameReader> reader_;
};

TEST_F(LspServer, RenameWaitsForTheFirstReading) {
  std::promise<void> known;
  *options_ = [ready = known.get_future().share()](const std::string&) {
    ready.wait();
    return DeckOptions();
  };
  open("mesh.k", mesh_text);
  EXPECT_EQ(renamed(), "the files of the deck are still being read; try again");
  known.set_value();
  audited();
  EXPECT_EQ(renamed(), "2 files");
}

TEST_F(LspServer, ADeckThatCannotBeReadIsNotWaitedFor) {
  *options_ = [calls = std::make_shared<std::atomic<int>>(0)](const std::string&) {
    if ((*calls)++ < 2) throw std::runtime_error("no memory");  // reading, audit
    return DeckOptions();
  };
  open("mesh.k", mesh_text);
  EXPECT_NE(audited().find("main.k: no memory"), std::string::npos);
  EXPECT_EQ(renamed(), "the files of the deck cannot be read; save one to try again");
  save("mesh.k");
  audited();
  EXPECT_EQ(renamed(), "2 files");
}

TEST_F(LspServer, WhatIsAnsweredIsNotCancelled) {
  const json question{{"id", 500}, {"method", "textDocument/hover"}, {"params", json::object()}};
  send(question);
  EXPECT_EQ(answer_to(500)["error"]["code"], Failure::invalid_params);
  notify("$/cancelRequest", {{"id", 500}});
  send(question);
  EXPECT_EQ(answer_to(500)["error"]["code"], Failure::invalid_params) << "another request with the same id";
  send({{"id", 501}, {"method", "$/cancelRequest"}, {"params", {{"id", 501}}}});
  EXPECT_EQ(answer_to(501)["error"]["code"], Failure::method_not_found);
}

TEST_F(LspServer, IdsAreNumbersTextsOrNull) {
  for (const json& id : {json(500), json(-1), json("a"), json(1.5), json()}) {
    send({{"id", id}, {"method", "no/such"}});
    EXPECT_EQ(answer_to(id)["error"]["code"], Failure::method_not_found) << id;
    send({{"id", id}, {"method", 5}});
    EXPECT_EQ(answer_to(id)["error"]["code"], Failure::invalid_request) << id;
  }
  for (const json& id : {json(true), json::array(), json::object()}) {
    send({{"id", id}, {"method", "textDocument/hover"}});
    EXPECT_EQ(answer_to(json())["error"]["code"], Failure::invalid_request) << id;
  }
}

TEST_F(LspServer, FaultsOfSettingsAreMarkedUntilTheyAreGone) {
  const json asked = wait([](const json& m) { return m.value("method", "") == "client/registerCapability"; });
  EXPECT_EQ(asked["params"]["registrations"][0]["registerOptions"]["watchers"][0]["globPattern"], "**/gapcheck.toml");
  const auto broken = std::make_shared<std::atomic<bool>>(true);
  *options_ = [broken, file = (folder_ / "gapcheck.toml").string()](const std::string&) {
    DeckOptions options;
    if (*broken) options.faults.push_back({Severity::error, file, 3, "unknown key"});
    return options;
  };
  open("main.k", deck_text);
  audited();
  ASSERT_TRUE(shows("gapcheck.toml", "unknown key"));
  EXPECT_EQ(published_[uri("gapcheck.toml")][0]["range"]["start"]["line"], 2);
  *broken = false;
  notify("workspace/didChangeWatchedFiles", {{"changes", json::array()}});
  audited();
  EXPECT_TRUE(published_[uri("gapcheck.toml")].empty());
}

TEST_F(LspServer, AnIncludeThatTheEditorHasTakenOut) {
  open("mesh.k", mesh_text);
  audited();
  open("main.k", deck_text);
  audited();
  EXPECT_EQ(renamed(), "2 files");
  change("main.k", "*KEYWORD\n*PART\nplate\n         1         1         1\n*END\n");
  expect_renamed("1 files");
  // Not saved: the file counts again.
  notify("textDocument/didClose", {{"textDocument", {{"uri", uri("main.k")}}}});
  expect_renamed("2 files");
}

TEST_F(LspServer, FindingsOfAnIncludeThatWasADeckOfItsOwn) {
  *options_ = [mesh = (folder_ / "mesh.k").string()](const std::string& deck) {
    const std::string name = std::filesystem::path(deck).filename().string();
    return DeckOptions{{}, {{Severity::warning, mesh, 1, "audited with " + name}}};
  };
  std::filesystem::remove(folder_ / "main.k");
  open("mesh.k", mesh_text);
  audited();
  EXPECT_TRUE(shows("mesh.k", "audited with mesh.k"));
  write("main.k", deck_text);
  save("mesh.k");
  audited();
  EXPECT_TRUE(shows("mesh.k", "audited with main.k"));
  EXPECT_FALSE(shows("mesh.k", "audited with mesh.k"));
}

}  // namespace
}  // namespace gapcheck::app::lsp
