// Writes a messag file as big as wanted, as after the initialisation of a model full of penetrations.
//   gapcheck_make_messag FILE [BLOCKS] [MEGABYTES]
// BLOCKS (default 1000000) messages 40565; lines of the memory trace between them fill the file up to MEGABYTES
// (default 1000).
#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "results/log/write_messag.hpp"

namespace {

using gapcheck::Penetration;
using gapcheck::Report;
using gapcheck::Vector;

constexpr std::uint64_t contacts = 40;

Penetration penetration(std::uint64_t i) {
  Penetration p;
  p.contact = static_cast<std::uint32_t>(i % contacts);
  p.node = static_cast<std::int64_t>(i + 1);
  p.segment_number = static_cast<std::uint32_t>(i % 5000 + 1);
  const auto corner = static_cast<std::int64_t>(i * 7 % 2'000'000);
  p.segment = {corner + 1, corner + 2, corner + 1002, i % 5 == 0 ? corner + 1002 : corner + 1001};
  p.depth = 1e-3 * static_cast<double>(i * 37 % 1999 + 1);
  p.contact_distance = 2.5;
  p.s = static_cast<double>(i % 21) / 10 - 1;
  p.t = static_cast<double>(i % 17) / 8 - 1;
  p.original = Vector(static_cast<double>(i % 1000), static_cast<double>(i / 1000), -3.25);
  p.moved_to = p.original + Vector(0, 0, 1.002 * p.depth);
  p.outcome = gapcheck::Outcome::moved;
  return p;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: gapcheck_make_messag FILE [BLOCKS] [MEGABYTES]\n");
    return 2;
  }
  const std::uint64_t blocks = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1'000'000;
  const std::uint64_t bytes = (argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1000) * 1'000'000;
  std::FILE* file = std::fopen(argv[1], "wb");
  if (file == nullptr) {
    std::fprintf(stderr, "gapcheck_make_messag: error: %s cannot be written\n", argv[1]);
    return 2;
  }
  Report piece;
  for (std::uint64_t i = 0; i < contacts; ++i) piece.contacts.emplace_back().id = static_cast<std::int64_t>(i + 1);
  std::uint64_t written = 0, memory = 1'000'000;
  bool failed = false;
  const auto write = [&](std::string_view text) {
    failed = failed || std::fwrite(text.data(), 1, text.size(), file) != text.size();
    written += text.size();
  };
  constexpr std::uint64_t step = 1000;
  for (std::uint64_t i = 0; i < blocks && !failed; i += step) {
    piece.penetrations.clear();
    for (std::uint64_t j = i; j < blocks && j < i + step; ++j) piece.penetrations.push_back(penetration(j));
    write(gapcheck::results::write_messag(piece));
    fmt::memory_buffer trace;
    for (; written + trace.size() < bytes * (i + step) / blocks; memory += 17)
      fmt::format_to(std::back_inserter(trace), " expanding   memory to {:11} d {:11} contact segment data 3\n", memory,
                     memory * 2);
    write({trace.data(), trace.size()});
  }
  failed = std::fclose(file) != 0 || failed;
  if (failed) std::fprintf(stderr, "gapcheck_make_messag: error: %s was not written to its end\n", argv[1]);
  return failed ? 2 : 0;
}
