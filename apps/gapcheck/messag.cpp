#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "commands.hpp"
#include "common/mesh.hpp"
#include "options.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "report/check_c_view.hpp"
#include "report/describe.hpp"
#include "results/solver_log.hpp"

namespace gapcheck::app {
namespace {

struct Arguments {
  std::vector<std::string> files;
  results::LogOptions log;
  report::CheckCOptions pick;
  std::string deck, d3plot;
  OutputOptions output;
  ExportOptions exports;
  std::size_t jobs = 0;
};

void add_selection(CLI::App& command, Arguments& arguments) {
  const CLI::Validator amount(check_amount, ""), id(check_id, "");
  const std::vector<CLI::Option*> options{
      add_list(command, "--contact", arguments.pick.sid, "Only these contacts")->check(id)->type_name("IDS"),
      command.add_option("--ptol", arguments.pick.ptol, "Only penetrations and separations above X")
          ->check(amount)
          ->type_name("X"),
      command.add_option("--rtol", arguments.pick.rtol, "Only penetrations with a remaining distance below X")
          ->check(amount)
          ->type_name("X")};
  for (CLI::Option* option : options) option->group("Selection");
}

void add_input(CLI::App& command, Arguments& arguments) {
  const std::vector<CLI::Option*> options{
      command.add_option("--d3hsp", arguments.log.d3hsp, "d3hsp file, if it is not beside the first file")
          ->type_name("FILE"),
      add_list(command, "--messages", arguments.log.message_files, "Additions to the table of known messages")
          ->type_name("FILE"),
      command.add_option("--deck", arguments.deck, "Keyword deck of the run: coordinates and parts of the nodes")
          ->type_name("DECK"),
      command
          .add_option("-g,--d3plot", arguments.d3plot,
                      "d3plot of the run, for the same; one beside the first file is found")
          ->type_name("FILE")};
  for (CLI::Option* option : options) option->group("Input");
}

int show_logs(const Arguments& arguments) {
  const JobLimit limit(arguments.jobs);
  Diagnostics diagnostics;
  const bool talk = !arguments.output.text.quiet;
  auto read = [&] {
    const Progress progress("reading " + report::printable(arguments.files.front()), talk);
    return results::read_solver_logs(arguments.files, arguments.log, diagnostics);
  }();
  auto mesh = find_mesh(arguments.deck, arguments.d3plot, arguments.files.front(), diagnostics);
  print(diagnostics, !talk);
  if (!read || !mesh) {
    print(!read ? read.error() : mesh.error());
    if (!read) return failed;
  }
  bool complete = mesh.ok() && !diagnostics.has_errors();
  Report report = report::pick(std::move(read).value(), arguments.pick);
  results::MeshSource known;
  if (mesh) known = std::move(mesh).value();
  add_parts(report, known);
  complete = write(report, arguments.output) && complete;
  complete = write(report, arguments.exports, positions(known)) && complete;
  return complete ? exit_code(report, arguments.output.fail_on) : failed;
}

}  // namespace

void add_messag(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("messag", "Show what the solver's message files say of the contacts");
  command->set_version_flag("--version", "gapcheck " GAPCHECK_VERSION);
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("FILE", arguments->files, "messag, mesNNNN, d3hsp, status.out files of one run")
      ->required()
      ->type_name("");
  add_selection(*command, *arguments);
  add_output(*command, arguments->output);
  add_exports(*command, arguments->exports);
  add_input(*command, *arguments);
  add_jobs(*command, arguments->jobs);
  command->callback([&action, arguments] { action = [arguments] { return show_logs(*arguments); }; });
}

}  // namespace gapcheck::app
