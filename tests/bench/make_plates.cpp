// Writes the benchmark deck: make_plates N FILE [--stray]
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "scenes/plates.hpp"

int main(int argc, char** argv) {
  const int n = argc >= 3 ? std::atoi(argv[1]) : 0;
  const bool stray = argc == 4 && std::string_view(argv[3]) == "--stray";
  if (n < 1 || n > 2000 || argc > 4 || (argc == 4 && !stray)) {
    std::fputs("usage: gapcheck_make_plates N FILE [--stray]   (N from 1 to 2000)\n", stderr);
    return 2;
  }
  std::ofstream file(argv[2], std::ios::binary);
  file << gapcheck::bench::plates_deck(n, stray);
  file.close();
  if (!file) std::fprintf(stderr, "cannot write %s\n", argv[2]);
  return file ? 0 : 2;
}
