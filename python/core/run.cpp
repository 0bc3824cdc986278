#include <gapcheck/run.hpp>
#include <string>

#include "callback.hpp"
#include "errors.hpp"
#include "module.hpp"
#include "options.hpp"
#include "record.hpp"

namespace gapcheck::python {
namespace {

const char* end_name(api::RunEnd end) {
  switch (end) {
    case api::RunEnd::time:
      return "time";
    case api::RunEnd::cycles:
      return "cycles";
    case api::RunEnd::energy:
      return "energy";
    case api::RunEnd::step:
      return "step";
    case api::RunEnd::stopped:
      return "stopped";
    case api::RunEnd::failed:
      break;
  }
  return "failed";
}

api::RunSummary run_of(const py::object& deck_path, const py::object& directory_path, const py::dict& options) {
  const std::string deck = path_of(deck_path), directory = path_of(directory_path);
  const Options given(options);
  api::RunOptions settings;
  given.take(settings.includes);
  given.take("until", settings.until);
  std::size_t cycles = 0;
  given.take("cycles", cycles);
  settings.cycles = cycles;
  given.take("ignore_unsupported", settings.ignore_unsupported);
  given.take("printed_stiffness", settings.printed_stiffness);
  given.take("binout", settings.binout);
  given.take("replace_foreign", settings.replace_foreign);
  given.take_jobs(settings.jobs);
  Callback watch(given.function("watch"));
  // The state is copied: Python may keep it.
  settings.watch = [&watch](const api::RunState& state) { return watch([&] { return py::make_tuple(state); }); };
  auto summary = without_lock([&] { return api::run_deck(deck, directory, settings); });
  watch.raise_again();
  return taken(std::move(summary));
}

py::array force(const double (&xyz)[3]) { return py::array_t<double>(3, xyz); }

void add_states(py::module_& module) {
  using api::RunContact, api::RunState;
  Record<RunContact>(module, "RunContact", "What one contact does at a moment of a run, and has done since its start.")
      .add("id", &RunContact::id)
      .add("touching", &RunContact::touching, "tracked nodes with a force")
      .add("released", &RunContact::released, "tracked nodes without a force because they were too deep")
      .add("moved", &RunContact::moved, "nodes that were put onto the surface since the start")
      .call(
          "force_a", [](const RunContact& self) { return force(self.force_a); }, "3, on the nodes of side A")
      .call(
          "force_b", [](const RunContact& self) { return force(self.force_b); }, "3; zero for single surfaces")
      .add("energy_a", &RunContact::energy_a, "taken from the nodes of side A since the start")
      .add("energy_b", &RunContact::energy_b)
      .add("friction", &RunContact::friction, "of it by friction");
  Record<RunState>(module, "RunState", "A moment of a run. Units of the model.")
      .add("time", &RunState::time)
      .add("end_time", &RunState::end_time, "infinite: the run ends after a number of cycles")
      .add("step", &RunState::step, "the coming time step")
      .add("cycle", &RunState::cycle)
      .add("kinetic", &RunState::kinetic)
      .add("internal", &RunState::internal)
      .add("hourglass", &RunState::hourglass)
      .add("sliding", &RunState::sliding)
      .add("external", &RunState::external)
      .add("total", &RunState::total)
      .add("energy_ratio", &RunState::energy_ratio, "total energy over what was there or was put in")
      .add("seconds", &RunState::seconds, "of wall clock since the first cycle")
      .add_list("contacts", &RunState::contacts, "RunContact of those that are calculated, in deck order");
}

}  // namespace

void add_run(py::module_& module) {
  using api::RunEnergy, api::RunSummary;
  add_states(module);
  Record<RunEnergy>(module, "RunEnergy", "Energy of a part or a contact since the start, by its work and by its state.")
      .add("name", &RunEnergy::name)
      .add("work", &RunEnergy::work)
      .add("state", &RunEnergy::state)
      .add("covered", &RunEnergy::covered, "False: no state tells its energy");
  Record<RunSummary>(module, "RunSummary", "What became of a run.")
      .call(
          "end", [](const RunSummary& self) { return end_name(self.end); },
          "'time', 'cycles', 'energy', 'step', 'stopped' or 'failed'")
      .add("failure", &RunSummary::failure, "why it failed; empty: it did not")
      .add("state", &RunSummary::state, "the last RunState")
      .add("state_energy_ratio", &RunSummary::state_energy_ratio)
      .add_list("energies", &RunSummary::energies, "RunEnergy of parts, springs and contacts")
      .call(
          "files", [](const RunSummary& self) { return py::tuple(path_texts(self.files)); },
          "names of the files in the directory")
      .add("plotted_states", &RunSummary::plotted_states, "in the d3plot")
      .add_list("diagnostics", &RunSummary::diagnostics,
                "what is calculated in another way than the deck says, by file and line");
  module.def("run_deck", run_of);
}

}  // namespace gapcheck::python
