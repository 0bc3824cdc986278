#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "results/curves/run_results.hpp"

namespace gapcheck::results {

/// A folder of one test's own, with what a reader of its binout has said.
class BinoutFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path() const { return (folder_ / "binout0000").string(); }
  RunResults read_folder() {
    Diagnostics diagnostics;
    RunResults run = read_run_results(folder_.string(), true, diagnostics);
    said_.clear();
    for (const Diagnostic& diagnostic : diagnostics.sorted()) said_ += diagnostic.message + "\n";
    return run;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("gapcheck_binout_" + std::to_string(::getpid()));
  std::string said_;
};

}  // namespace gapcheck::results
