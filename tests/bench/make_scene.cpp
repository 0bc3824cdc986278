// Writes the deck of a scene: gapcheck_make_scene KIND ELEMENTS FILE. Prints what the deck has.
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "scenes/scenes.hpp"

int main(int argc, char** argv) {
  using namespace gapcheck::bench;
  const auto kind = argc == 4 ? scene_kind(argv[1]) : std::nullopt;
  std::uint64_t elements = 0;
  if (argc == 4) {
    const std::string_view text = argv[2];
    std::from_chars(text.data(), text.data() + text.size(), elements);
  }
  if (!kind || elements < 1000 || elements > 50'000'000) {
    std::fputs("usage: gapcheck_make_scene KIND ELEMENTS FILE   (ELEMENTS from 1000 to 50000000)\nkinds:", stderr);
    for (const SceneKind each : all_scenes) std::fprintf(stderr, " %s", name(each).data());
    std::fputs("\n", stderr);
    return 2;
  }
  std::FILE* file = std::fopen(argv[3], "wb");
  bool good = file != nullptr;
  SceneFacts facts;
  if (good) {
    facts = write_scene(*kind, elements, [&](std::string_view piece) {
      good = good && std::fwrite(piece.data(), 1, piece.size(), file) == piece.size();
    });
    good = std::fclose(file) == 0 && good;
  }
  if (!good) {
    std::fprintf(stderr, "cannot write %s\n", argv[3]);
    return 2;
  }
  std::printf("%llu elements, %llu nodes, from %llu to %llu penetrations\n",
              static_cast<unsigned long long>(facts.elements), static_cast<unsigned long long>(facts.nodes),
              static_cast<unsigned long long>(facts.fewest_penetrations),
              static_cast<unsigned long long>(facts.most_penetrations));
  return 0;
}
