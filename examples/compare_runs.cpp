// Compares two runs, two decks, or a deck and a run: compare_runs A B. Exit code 1 if they differ.
#include <cstdio>
#include <gapcheck/compare.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto result = gapcheck::api::compare(argv[1], argv[2]);
  if (!result) {
    std::fprintf(stderr, "%s: %s\n", result.error().file.c_str(), result.error().message.c_str());
    return 2;
  }
  const gapcheck::api::Comparison& comparison = result.value();
  for (const auto& contact : comparison.contacts)
    std::printf("contact %lld: %llu nodes agree, %llu differ, %llu only in A, %llu only in B\n",
                static_cast<long long>(contact.id), static_cast<unsigned long long>(contact.agree),
                static_cast<unsigned long long>(contact.depth_differs),
                static_cast<unsigned long long>(contact.only_first),
                static_cast<unsigned long long>(contact.only_second));
  if (comparison.curves) {
    std::printf("curves: %zu agree, %zu differ\n", comparison.curves->agree, comparison.curves->differ);
    for (const auto& pair : comparison.curves->pairs)
      if (pair.verdict == gapcheck::api::CurvePair::Verdict::differs)
        std::printf("  %s: %.3g of the larger one\n", pair.name.c_str(), pair.relative_difference);
  }
  std::puts(comparison.equal ? "equal" : "different");
  if (!comparison.complete) return 2;
  return comparison.equal ? 0 : 1;
}
