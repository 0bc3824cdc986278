// Runs a deck, shows how it goes, and ends it if energy appears from nowhere: run_and_watch DECK DIRECTORY
#include <cmath>
#include <cstdio>
#include <gapcheck/run.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  gapcheck::api::RunOptions options;
  double next = 0;
  options.watch = [&next](const gapcheck::api::RunState& state) {
    if (state.time >= next) {
      std::printf("%3.0f %%", 100 * state.time / state.end_time);
      for (const auto& contact : state.contacts)
        std::printf("  contact %lld: %llu nodes touch", static_cast<long long>(contact.id),
                    static_cast<unsigned long long>(contact.touching));
      std::printf("\n");
      next += state.end_time / 4;
    }
    return std::abs(state.energy_ratio - 1) < 0.1;
  };
  const auto result = gapcheck::api::run_deck(argv[1], argv[2], options);
  if (!result) {
    std::fprintf(stderr, "%s: %s\n", result.error().file.c_str(), result.error().message.c_str());
    for (const auto& each : result.error().diagnostics)
      std::fprintf(stderr, "%s:%u: %s\n", each.file.c_str(), static_cast<unsigned>(each.line), each.message.c_str());
    return 2;
  }
  const gapcheck::api::RunSummary& run = result.value();
  std::printf("%s after %llu cycles, %zu files, energy ratio %.3f\n",
              run.end == gapcheck::api::RunEnd::time ? "ended" : "cut short",
              static_cast<unsigned long long>(run.state.cycle), run.files.size(), run.state.energy_ratio);
  return run.end == gapcheck::api::RunEnd::time ? 0 : 1;
}
