#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "records/report.hpp"
#include "results/log/message_log.hpp"
#include "results/log/solver_log.hpp"

namespace gapcheck::results {

/// Where a contact's type code was read; a later kind replaces an earlier one.
enum class TypeSource : std::uint8_t { none, timestep, echo, summary };

/// Gathers what the files of one run say and makes one report of it. Records refer to contacts by slot until then. What
/// several files repeat counts once.
class LogCollector {
 public:
  explicit LogCollector(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// From a companion file only contacts, time steps and facts are taken, no messages or records.
  void begin_file(const std::string& name, bool companion);
  void end_file();
  [[nodiscard]] bool companion() const { return companion_; }
  [[nodiscard]] std::uint32_t file() const { return file_; }
  [[nodiscard]] const std::string& file_name() const { return files_.back(); }
  void error(std::uint32_t line, std::string message) { diagnostics_.error(file_name(), line, std::move(message)); }
  void warning(std::uint32_t line, std::string message) { diagnostics_.warning(file_name(), line, std::move(message)); }

  /// The kind of the current file; decides which counts add up and which repeat others.
  void mark_d3hsp() { d3hsp_ = true; }
  void mark_stdout() { stdout_ = true; }
  [[nodiscard]] bool is_d3hsp() const { return d3hsp_; }
  void set_message_limit(std::int64_t limit) { message_limit_ = limit; }

  std::uint32_t slot(std::int64_t contact_id);
  /// Valid until the next file; slots are those of slot().
  ContactSummary& contact(std::uint32_t slot) { return contacts_[slot].summary; }
  void set_type(std::uint32_t slot, std::string_view type, TypeSource source);
  /// A count of penetrations that the current file gives for an interface.
  void count_penetrations(std::uint32_t slot, std::uint64_t count);

  /// A summary of initial penetrations in the current file.
  void add_summary(std::uint32_t slot, const InitialSummary& summary);

  SolverRun& run() { return run_; }
  MessageLog& messages() { return messages_; }
  void add(const Penetration& record) { penetrations_.push_back(record); }
  void add(const TieFailure& record) { tie_failures_.push_back(record); }
  void add(const RigidwallPenetration& record) { run_.rigidwalls.push_back(record); }
  /// The first block of each contact and side counts.
  void add(const SurfaceTimestep& step);
  void count_bytes(std::uint64_t bytes, std::uint64_t lines);

  Report finish(const LogOptions& options);

 private:
  struct Contact {
    ContactSummary summary;
    TypeSource type_source = TypeSource::none;
    bool timestep_a = false, timestep_b = false;
    // A d3hsp and the screen's output repeat what the message files say; message files of several ranks add up.
    std::uint64_t in_file = 0, in_message_files = 0, in_copies = 0;
    std::optional<InitialSummary> summary_in_file;
  };

  void sort_contacts(const LogOptions& options);
  void sort_records();
  void drop_not_found_elsewhere();
  void count_records(Report& report) const;

  Diagnostics& diagnostics_;
  std::vector<std::string> files_;
  std::uint32_t file_ = 0;
  bool companion_ = false, d3hsp_ = false, stdout_ = false;
  std::int64_t message_limit_ = 0;
  std::unordered_map<std::int64_t, std::uint32_t> slots_;
  std::deque<Contact> contacts_;
  std::vector<Penetration> penetrations_;
  std::vector<TieFailure> tie_failures_;
  SolverRun run_;
  MessageLog messages_;
  std::uint64_t bytes_ = 0, lines_ = 0, repeated_ = 0;
};

}  // namespace gapcheck::results
