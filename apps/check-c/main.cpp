#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "base/file_writer.hpp"
#include "base/parallel.hpp"
#include "base/system/memory.hpp"
#include "common/failures.hpp"
#include "common/file_guard.hpp"
#include "common/mesh.hpp"
#include "common/message_line.hpp"
#include "common/signals.hpp"
#include "common/standard_output.hpp"
#include "common/version.hpp"
#include "report/export/exports.hpp"
#include "report/text/check_c_view.hpp"
#include "report/write/writers.hpp"
#include "results/log/solver_log.hpp"

namespace gapcheck::check_c {
namespace {

enum Exit : int { clean = 0, warned = 1, failed = 2 };

void complain(const Diagnostic& diagnostic) { std::fputs(app::line_of("check-c", diagnostic).c_str(), stderr); }

void print(const Diagnostics& diagnostics, bool quiet) {
  for (const Diagnostic& diagnostic : diagnostics.sorted())
    if (!quiet || diagnostic.severity == Severity::error) complain(diagnostic);
  if (const std::size_t more = diagnostics.dropped(); more > 0)
    std::fputs(fmt::format("check-c: ... and {} more messages\n", more).c_str(), stderr);
}

bool shows_parts(const Arguments& arguments) { return arguments.view.pid || arguments.view.psum; }
bool mesh_given(const Arguments& arguments) { return !arguments.deck.empty() || !arguments.d3plot.empty(); }

/// The mesh; empty if the options need none.
Result<results::MeshSource> load_mesh(const Arguments& arguments, Diagnostics& diagnostics) {
  if (!shows_parts(arguments) && !mesh_given(arguments) && !arguments.key && !arguments.medina)
    return results::MeshSource{};
  return app::find_mesh({arguments.deck, {}, arguments.d3plot, arguments.files.front()}, diagnostics);
}

/// An error if parts are to be shown and nothing tells them.
Status check_parts(const Arguments& arguments, const results::MeshSource& mesh) {
  if (!shows_parts(arguments) || mesh_given(arguments) || !mesh.parts.empty()) return {};
  return plain_error(
      "parts are not known: there is no d3plot beside the first file; give -g <d3plot> or --deck <file>");
}

constexpr const char *key_file = "check-c.key", *session_file = "check-c.ses", *protocol_file = "check-c.prt";

/// An error if a file to write is one of those that are read.
Status check_files(const Arguments& arguments) {
  std::vector<app::PlannedOutput> outputs;
  const auto plan = [&](const char* option, const char* file) {
    outputs.push_back({option, file, "", "the input another name, or work in another directory"});
  };
  if (arguments.key) plan("-key:", key_file);
  if (arguments.ani || arguments.a4sel) plan(arguments.ani ? "-ani:" : "-a4sel:", session_file);
  if (arguments.medina) plan("-medina:", protocol_file);
  if (outputs.empty()) return {};
  std::vector<app::ReadInput> read;
  for (const std::string& file : arguments.files) read.push_back({file, "a file that is read"});
  app::add_run_files(std::filesystem::path(arguments.files.front()).parent_path().string(), read);
  read.push_back({arguments.hsp, "the d3hsp file"});
  read.push_back({arguments.d3plot, "the d3plot file"});
  for (const std::string& table : arguments.message_files) read.push_back({table, "a table of messages"});
  const keyword::ReadOptions deck_options;
  app::DeckFiles decks(deck_options);
  if (!arguments.deck.empty()) app::add_deck_files(arguments.deck, decks, outputs, read);
  return app::check_outputs(read, outputs);
}

/// Writes check-c.* into the working directory and says so.
void write_exports(const Report& report, const Arguments& arguments, const report::NodePosition& position,
                   app::Failures& failures) {
  const auto write = [&](const char* path, const std::string& text) {
    const Status written = write_file(path, text);
    failures.add(written.ok() ? app::write_to_standard_output(fmt::format("{} written\n", path)) : written);
  };
  if (arguments.key) write(key_file, report::keyword_beams(report, position));
  if (arguments.ani || arguments.a4sel) write(session_file, report::animator_session(report, arguments.a4sel));
  if (arguments.medina) write(protocol_file, report::medina_protocol(report, position, arguments.medina_node));
}

/// Interfaces of -sid that no file mentions: they may have no warnings, or be misspelt.
void note_unknown_interfaces(const Report& report, const Arguments& arguments) {
  if (arguments.quiet) return;
  for (const std::int64_t id : arguments.view.sid) {
    bool known = false;
    for (const ContactSummary& contact : report.contacts) known = known || contact.id == id;
    if (!known)
      complain(Diagnostic{Severity::warning, "", 0, fmt::format("-sid {}: the files mention no such interface", id)});
  }
}

int check(const Arguments& arguments) {
  const JobLimit limit(arguments.jobs);
  if (const Status status = check_files(arguments); !status.ok()) {
    complain(status.error());
    return failed;
  }
  Diagnostics diagnostics;
  results::LogOptions options;
  options.d3hsp = arguments.hsp;
  options.message_files = arguments.message_files;
  auto read = results::read_solver_logs(arguments.files, options, diagnostics);
  app::Failures failures(complain);
  results::MeshSource mesh;
  if (read) {
    if (auto loaded = load_mesh(arguments, diagnostics)) {
      mesh = std::move(loaded).value();
      failures.add(check_parts(arguments, mesh));
    } else {
      failures.add(loaded.error());
    }
  }
  print(diagnostics, arguments.quiet);
  failures.count(diagnostics);
  if (!read) {
    complain(read.error());
    return failed;
  }
  results::add_parts(mesh, read.value());
  note_unknown_interfaces(read.value(), arguments);
  const Report picked = report::pick(std::move(read).value(), arguments.view);
  failures.add(app::write_to_standard_output(report::check_c_text(picked, arguments.view)));
  const auto position = app::positions(mesh);
  write_exports(arguments.top_given ? report::top_only(picked, arguments.view) : picked, arguments, position, failures);
  if (arguments.stats) std::fputs(report::statistics(picked).c_str(), stderr);
  if (failures.any()) return failed;
  return report::warning_count(picked) > 0 ? warned : clean;
}

/// Prints the text and nothing else.
int show(const std::string& text) {
  app::Failures failures(complain);
  failures.add(app::write_to_standard_output(text));
  return failures.any() ? failed : clean;
}

int run(const std::vector<std::string>& words) {
  if (words.empty()) {
    show(usage());
    return failed;
  }
  const Result<Arguments> arguments = parse(words);
  if (!arguments) {
    complain(plain_error(arguments.error().message + "; check-c -help lists the options"));
    return failed;
  }
  if (arguments.value().help) return show(usage());
  if (arguments.value().version) return show(app::version_line("check-c") + "\n");
  system::keep_freed_memory();
  return check(arguments.value());
}

}  // namespace
}  // namespace gapcheck::check_c

int main(int argc, char** argv) {
  // Nothing after the catch may allocate.
  try {
    gapcheck::app::prepare_process();
    return gapcheck::check_c::run({argv + (argc > 0 ? 1 : 0), argv + argc});
  } catch (const std::bad_alloc&) {
    std::fputs("check-c: error: not enough memory\n", stderr);
  } catch (const std::exception& error) {
    const bool no_thread = std::strstr(error.what(), "pthread_create") != nullptr;
    std::fprintf(stderr, "check-c: error: %s%s\n", error.what(), no_thread ? "; with --jobs 1 none is needed" : "");
  }
  return gapcheck::check_c::failed;
}
