#include "campaign/deck_key.hpp"

#include <chrono>
#include <cstdint>
#include <optional>

#include "base/file_bytes.hpp"
#include "report/archive/archive.hpp"

// The overloads that archives look for are in the namespace of the archive. Each names all members, so that a new one
// does not compile before it is considered here.
namespace gapcheck::report {

static void members(ArchiveWriter& archive, const audit::IdRange& range) { archive(range.first, range.last); }

static void members(ArchiveWriter& archive, const audit::IgnoreEntry& entry) {
  const auto& [rules, contacts, nodes, parts, elements, files, base, ptol, ratio, until, reason, file, line] = entry;
  std::optional<std::int64_t> last_day;
  if (until) last_day = std::chrono::sys_days(*until).time_since_epoch().count();
  archive(rules, contacts, nodes, parts, elements, files, base, ptol, ratio, last_day, reason, file, line);
}

static void members(ArchiveWriter& archive, const model::Assumption& assumption) {
  const auto& [field, value] = assumption;
  archive(field, value);
}

static void members(ArchiveWriter& archive, const keyword::ReadOptions& options) {
  const auto& [directories, parameters, skip_missing, depth, files, repeated, cache, replaced] = options;
  archive(directories, parameters, skip_missing, depth, files, repeated);
}

/// Without the day, and without who watches.
static void members(ArchiveWriter& archive, const audit::AuditOptions& options) {
  const auto& [read, select, ignore, contacts, parts, ignores, as_if, severities, thresholds, today, ptol, rtol, ratio,
               millimetre, exact, brute_force, scene, mesh, named, portability, watch] = options;
  archive(read, select, ignore, contacts, parts, ignores, as_if, severities, thresholds, ptol, rtol, ratio, millimetre,
          exact, brute_force, scene, mesh, named, portability);
}

}  // namespace gapcheck::report

namespace gapcheck::app {
namespace {

void add_file(const std::string& path, report::ArchiveWriter& key) {
  const auto bytes = FileBytes::open(path);
  const ContentHash hash = bytes ? hash_of(bytes.value().bytes()) : ContentHash();
  key(path, static_cast<bool>(bytes), hash.low, hash.high);
}

}  // namespace

ContentHash key_of(const std::string& deck, const audit::AuditOptions& options, const std::string& baseline,
                   const std::vector<std::string>& others, DeckFiles& files) {
  report::ArchiveWriter key;
  key(options, others);
  add_file(deck, key);
  for (const std::string& include : files.includes(deck)) add_file(include, key);
  bool ends = files.has_directives(deck);
  for (const audit::IgnoreEntry& entry : options.ignores) ends = ends || entry.until.has_value();
  if (!baseline.empty()) add_file(baseline, key);
  if (ends) key(static_cast<std::int64_t>(options.today.time_since_epoch().count()));
  return hash_of(key.take());
}

}  // namespace gapcheck::app
