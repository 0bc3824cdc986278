#pragma once
#include <cstddef>
#include <cstdint>
#include <gapcheck/report.hpp>
#include <gapcheck/result.hpp>
#include <optional>
#include <string>

namespace gapcheck::api {

/// Formats of a report.
enum class Format : std::uint8_t {
  text,    ///< for people, as `gapcheck audit` prints it, without colours
  json,    ///< schema gapcheck/1
  sarif,   ///< SARIF 2.1.0
  junit,   ///< JUnit XML
  github,  ///< annotations of GitHub
  gitlab,  ///< code quality report of GitLab
  csv,     ///< a table, one line per finding
  html,    ///< one file for a browser; with a picture of the mesh if AuditOptions::picture was set
  vtu,     ///< for ParaView, with depths and vectors; with the elements if AuditOptions::mesh was set
};

struct WriteOptions {
  std::size_t top = 5;      ///< text, junit, github: findings to list per contact or rule; the rest is counted
  bool list = false;        ///< all of them instead
  bool statistics = false;  ///< text, json: counters and times
  std::optional<Severity> fail_on = Severity::error;  ///< junit: least severity that fails a case; none: no case fails
};

/// The whole report as text in one of the formats, byte for byte what the command line writes. The same report gives
/// the same text, except for times in JSON and statistics. Works on what the report was made with: changes to its
/// members have no effect. A Report that no function of the library made is written as an empty one. The text of a
/// large report takes up to a gigabyte per million findings.
///
///     const std::string page = gapcheck::api::write(report, gapcheck::api::Format::html);
[[nodiscard]] std::string write(const Report& report, Format format, const WriteOptions& options = {});

}  // namespace gapcheck::api
