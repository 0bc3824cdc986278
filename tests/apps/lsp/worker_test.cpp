#include "lsp/worker.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stdexcept>

namespace gapcheck::app::lsp {
namespace {

using namespace std::chrono_literals;

/// Goes on as long as it may; true if it was asked to stop, false after ten seconds.
bool stopped(const Worker::GoOn& go_on) {
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (go_on())
    if (std::chrono::steady_clock::now() > end) return false;
  return true;
}

TEST(LspWorker, ANewerJobStopsTheOneThatRuns) {
  std::promise<void> begun;
  std::promise<bool> first, last;
  Worker worker;
  worker.start([&](const Worker::GoOn& go_on) {
    begun.set_value();
    first.set_value(stopped(go_on));
  });
  begun.get_future().wait();
  worker.start([&](const Worker::GoOn& go_on) { last.set_value(go_on()); });
  EXPECT_TRUE(first.get_future().get());
  EXPECT_TRUE(last.get_future().get());
}

TEST(LspWorker, AJobThatWaitsIsDropped) {
  std::promise<void> begun, go, last;
  std::atomic<bool> dropped{true};
  Worker worker;
  worker.start([&](const Worker::GoOn&) {
    begun.set_value();
    go.get_future().wait();
  });
  begun.get_future().wait();
  worker.start([&](const Worker::GoOn&) { dropped = false; });
  worker.start([&](const Worker::GoOn&) { last.set_value(); });
  go.set_value();
  last.get_future().wait();
  EXPECT_TRUE(dropped);
}

TEST(LspWorker, TheEndStopsAJob) {
  std::promise<void> begun;
  std::promise<bool> asked;
  {
    Worker worker;
    worker.start([&](const Worker::GoOn& go_on) {
      begun.set_value();
      asked.set_value(stopped(go_on));
    });
    begun.get_future().wait();
  }
  EXPECT_TRUE(asked.get_future().get());
}

TEST(LspWorker, AJobThatFailsIsTheOnlyOne) {
  std::promise<void> last;
  Worker worker;
  worker.start([](const Worker::GoOn&) { throw std::runtime_error("no memory"); });
  worker.start([&](const Worker::GoOn&) { last.set_value(); });
  EXPECT_EQ(last.get_future().wait_for(10s), std::future_status::ready);
}

}  // namespace
}  // namespace gapcheck::app::lsp
