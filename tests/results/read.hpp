#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "results/log/solver_log.hpp"

namespace gapcheck::results {

struct Read {
  Report report;
  std::vector<Diagnostic> diagnostics;
  bool errors = false;
};

inline Read read_text(const std::string& text, const LogOptions& options = {}) {
  Diagnostics diagnostics;
  Read read;
  read.report = read_solver_log_text(text, "messag", options, diagnostics);
  read.diagnostics = diagnostics.sorted();
  read.errors = diagnostics.has_errors();
  return read;
}

/// A folder of its own for the files of one test; gone at the end.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(std::filesystem::temp_directory_path() / ("gapcheck-" + name)) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

inline std::string read_bytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline const ContactSummary* contact_of(const Report& report, std::int64_t id) {
  const auto found =
      std::find_if(report.contacts.begin(), report.contacts.end(), [&](const auto& c) { return c.id == id; });
  return found == report.contacts.end() ? nullptr : &*found;
}

inline std::vector<std::int64_t> contact_ids(const Report& report) {
  std::vector<std::int64_t> ids;
  for (const ContactSummary& summary : report.contacts) ids.push_back(summary.id);
  return ids;
}

/// Empty: no message.
inline std::string first_error(const Read& read) {
  for (const Diagnostic& diagnostic : read.diagnostics)
    if (diagnostic.severity == Severity::error)
      return diagnostic.file + ":" + std::to_string(diagnostic.line) + ": " + diagnostic.message;
  return "";
}

}  // namespace gapcheck::results
