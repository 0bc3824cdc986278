#include <cstdlib>
#include <memory>
#include <utility>

#include "audit_decks.hpp"
#include "base/parallel.hpp"
#include "base/system/terminal.hpp"
#include "commands.hpp"
#include "common/version.hpp"
#include "lsp/server.hpp"
#include "options.hpp"

namespace gapcheck::app {

void add_lsp(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "lsp", "Serve an editor: what is wrong while one types, hover, completion, references, rename");
  command->set_version_flag("--version", version_line("gapcheck"));
  const auto arguments = std::make_shared<AuditArguments>();
  const auto stdio = std::make_shared<bool>(true);
  command->add_flag("--stdio", *stdio, "Speak on standard input and output, as is always done");
  add_settings(*command, arguments->settings_file);
  add_includes(*command, arguments->audit.read, arguments->missing_includes);
  add_jobs(*command, arguments->jobs);
  command->footer("Exit codes: 0 the editor ended it in the orderly way, 1 the editor is gone.");
  command->callback([&action, arguments, stdio] {
    action = [arguments] {
      const JobLimit limit(arguments->jobs);
      const auto options_of = [arguments](const std::string& deck) {
        Diagnostics faults;
        EditorAudit editor = editor_audit_of(deck, *arguments, faults);
        lsp::DeckOptions options{editor.audit, faults.sorted()};
        if (!editor.baseline.compare.empty())
          options.compare = [editor = std::move(editor)](Report& report) { return compare_for_editor(editor, report); };
        return options;
      };
      auto* server =
          new lsp::Server(system::standard_input, system::standard_output, options_of, version_line("gapcheck"));
      // Threads may still read a deck; nothing that they do is left half done.
      std::_Exit(server->run());
      return 0;
    };
  });
}

}  // namespace gapcheck::app
