#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "base/parallel.hpp"
#include "common/files.hpp"
#include "common/mesh.hpp"
#include "common/version.hpp"
#include "report/text/check_c_view.hpp"
#include "report/export/exports.hpp"
#include "report/write/writers.hpp"
#include "results/log/solver_log.hpp"

namespace gapcheck::check_c {
namespace {

enum Exit : int { clean = 0, warned = 1, failed = 2 };

void complain(const Diagnostic& diagnostic) { std::fputs(app::line_of("check-c", diagnostic).c_str(), stderr); }

void complain(const std::string& message) { complain(Diagnostic{Severity::error, "", 0, message}); }

void print(const Diagnostics& diagnostics, bool quiet) {
  for (const Diagnostic& diagnostic : diagnostics.sorted())
    if (!quiet || diagnostic.severity == Severity::error) complain(diagnostic);
  if (const std::size_t more = diagnostics.dropped(); more > 0)
    std::fputs(fmt::format("check-c: ... and {} more messages\n", more).c_str(), stderr);
}

/// False if standard output does not take the text.
bool print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return true;
  complain(Diagnostic{Severity::error, "standard output", 0,
                      fmt::format("cannot be written: {}", std::strerror(errno != 0 ? errno : EIO))});
  return false;
}

/// The mesh, where the options need one. False: it was needed and cannot be had; that has been said.
bool load_mesh(const Arguments& arguments, results::MeshSource& mesh, Diagnostics& diagnostics) {
  const bool parts = arguments.view.pid || arguments.view.psum;
  const bool given = !arguments.deck.empty() || !arguments.d3plot.empty();
  if (!parts && !given && !arguments.key && !arguments.medina) return true;
  auto found = app::find_mesh(arguments.deck, arguments.d3plot, arguments.files.front(), diagnostics);
  if (!found) {
    complain(found.error());
    return false;
  }
  mesh = std::move(found).value();
  if (!parts || given || !mesh.parts.empty()) return true;
  complain("parts are not known: there is no d3plot beside the first file; give -g <d3plot> or --deck <file>");
  return false;
}

/// Writes check-c.* into the working directory and says so.
bool write_exports(const Report& report, const Arguments& arguments, const report::NodePosition& position) {
  bool written = true;
  const auto write = [&](const char* path, const std::string& text) {
    if (const auto error = app::write_file(path, text)) {
      complain(*error);
      written = false;
    } else {
      written = print(fmt::format("{} written\n", path)) && written;
    }
  };
  if (arguments.key) write("check-c.key", report::keyword_beams(report, position));
  if (arguments.ani || arguments.a4sel) write("check-c.ses", report::animator_session(report, arguments.a4sel));
  if (arguments.medina) write("check-c.prt", report::medina_protocol(report, position, arguments.medina_node));
  return written;
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
  Diagnostics diagnostics;
  results::LogOptions options;
  options.d3hsp = arguments.hsp;
  options.message_files = arguments.message_files;
  auto read = results::read_solver_logs(arguments.files, options, diagnostics);
  results::MeshSource mesh;
  const bool meshed = read && load_mesh(arguments, mesh, diagnostics);
  print(diagnostics, arguments.quiet);
  if (!read) {
    complain(read.error());
    return failed;
  }
  app::add_parts(read.value(), mesh);
  note_unknown_interfaces(read.value(), arguments);
  const Report picked = report::pick(std::move(read).value(), arguments.view);
  bool done = print(report::check_c_text(picked, arguments.view)) && meshed;
  const auto position = app::positions(mesh);
  done = (arguments.top_given ? write_exports(report::top_only(picked, arguments.view), arguments, position)
                              : write_exports(picked, arguments, position)) &&
         done;
  if (arguments.stats) std::fputs(report::statistics(picked).c_str(), stderr);
  if (!done || diagnostics.has_errors()) return failed;
  return report::warning_count(picked) > 0 ? warned : clean;
}

int run(const std::vector<std::string>& words) {
  if (words.empty()) {
    print(usage());
    return failed;
  }
  Arguments arguments;
  if (const std::string wrong = parse(words, arguments); !wrong.empty()) {
    complain(wrong + "; check-c -help lists the options");
    return failed;
  }
  if (arguments.help) return print(usage()) ? clean : failed;
  if (arguments.version) return print(app::version_line("check-c") + "\n") ? clean : failed;
  return check(arguments);
}

}  // namespace
}  // namespace gapcheck::check_c

int main(int argc, char** argv) {
  // Nothing behind the catch may allocate.
  try {
    return gapcheck::check_c::run({argv + (argc > 0 ? 1 : 0), argv + argc});
  } catch (const std::bad_alloc&) {
    std::fputs("check-c: error: not enough memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "check-c: error: %s\n", error.what());
  }
  return gapcheck::check_c::failed;
}
