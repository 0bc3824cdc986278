// Rows of *NODE and *ELEMENT_SHELL in memory: read_rows_in_pieces(), as the model reads, and read_rows() beside what
// the language offers, on the same text. All ways must give the same numbers before any is timed. Prints one line of
// key=value per case: megabytes of text per second, and page faults per megabyte where memory is taken.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <random>

#include "base/parallel.hpp"
#include "keyword/rows.hpp"

namespace {

using namespace gapcheck;
using keyword::CardLayout;
using keyword::Format;
using keyword::Rows;

struct Case {
  std::string name, keyword, real_form;  ///< real_form: format of one coordinate; empty: elements
  std::size_t columns;                   ///< of the first, integer field
};

const std::vector<Case> cases{{"*NODE, 9 digits, E", "NODE", "{:16.8E}", 8},
                              {"*NODE, 8 digits, E", "NODE", "{:16.7E}", 8},
                              {"*NODE, short decimals", "NODE", "{:16.3f}", 8},
                              {"*NODE, 12 digits, decimals", "NODE", "{:16.8f}", 8},
                              {"*NODE, 9 digits, Fortran D", "NODE", "{:16.8E}", 8},
                              {"*NODE% (i10), 9 digits, E", "NODE%", "{:16.8E}", 10},
                              {"*NODE+ (long), 14 digits, E", "NODE+", "{:20.13E}", 20},
                              {"*NODE+ (long), 17 digits, decimals", "NODE+", "{:20.13f}", 20},
                              {"*ELEMENT_SHELL", "ELEMENT_SHELL", "", 8},
                              {"*ELEMENT_SHELL% (i10)", "ELEMENT_SHELL%", "", 10},
                              {"*ELEMENT_SHELL+ (long)", "ELEMENT_SHELL+", "", 20}};

/// The layout that the model reads the rows by: the first four fields of *NODE, six of *ELEMENT_SHELL.
CardLayout layout_of(const Case& c) {
  CardLayout layout = keyword::card_layout(c.real_form.empty() ? "ELEMENT_SHELL" : "NODE", "card1");
  layout.fields.resize(c.real_form.empty() ? 6 : 4);
  return layout;
}

std::string text_of(const Case& c, std::size_t rows) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-5000, 5000);
  std::string text = "*" + c.keyword + "\n";
  for (std::size_t i = 1; i <= rows; ++i) {
    text += fmt::format("{:{}}", i, c.columns);
    for (int k = 0; k < 3 && !c.real_form.empty(); ++k)
      text += fmt::format(fmt::runtime(c.real_form), coordinate(random));
    for (std::size_t k = 0; k < 5 && c.real_form.empty(); ++k)
      text += fmt::format("{:{}}", k == 0 ? 1 + i / 1000 : i + 1000 * (k / 2) + k, c.columns);
    text += '\n';
  }
  if (c.name.ends_with('D')) std::replace(text.begin() + 6, text.end(), 'E', 'D');
  return text;
}

/// Calls visit(line) for every line, which memchr finds.
template <class Visit>
void for_each_line(std::string_view body, const Visit& visit) {
  for (std::size_t at = 0; at < body.size();) {
    const void* newline = std::memchr(body.data() + at, '\n', body.size() - at);
    const std::size_t end =
        newline == nullptr ? body.size() : static_cast<std::size_t>(static_cast<const char*>(newline) - body.data());
    visit(body.substr(at, end - at));
    at = end + 1;
  }
}

/// Reads every field by convert(first, last, value); the yardsticks have room for the rows before they start.
template <class Convert>
void read_by(std::string_view body, const Case& c, Rows& rows, const Convert& convert) {
  const bool nodes = !c.real_form.empty();
  std::int64_t* integers = rows.integers.data();
  double* reals = rows.reals.data();
  const std::size_t width = nodes ? std::max<std::size_t>(16, c.columns) : c.columns;
  for_each_line(body, [&](std::string_view line) {
    convert(line.data(), line.data() + c.columns, *integers++);
    for (std::size_t at = c.columns; at < line.size(); at += width) {
      if (nodes)
        convert(line.data() + at, line.data() + at + width, *reals++);
      else
        convert(line.data() + at, line.data() + at + width, *integers++);
    }
  });
}

struct FromChars {
  template <class Value>
  void operator()(const char* first, const char* last, Value& value) const {
    while (first != last && *first == ' ') ++first;
    if (std::from_chars(first, last, value).ec != std::errc{}) value = -1;
  }
};

struct StandardC {
  void operator()(const char* first, const char* last, double& value) const {
    const auto text = copied(first, last);
    value = std::strtod(text.data(), nullptr);
  }
  void operator()(const char* first, const char* last, std::int64_t& value) const {
    const auto text = copied(first, last);
    value = std::strtoll(text.data(), nullptr, 10);
  }
  /// The field with an end of its own, since fields may touch.
  static std::array<char, 24> copied(const char* first, const char* last) {
    std::array<char, 24> text;
    std::memcpy(text.data(), first, static_cast<std::size_t>(last - first));
    text[static_cast<std::size_t>(last - first)] = '\0';
    return text;
  }
};

bool same(const Rows& a, const Rows& b) {
  return a.integers == b.integers && a.reals.size() == b.reals.size() &&
         std::memcmp(a.reals.data(), b.reals.data(), a.reals.size() * sizeof(double)) == 0;
}

double page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_minflt);
}

struct Way {
  std::string name;
  std::function<void()> run;
  std::function<void()> before = [] {};
  std::vector<double> seconds = {};
  double faults = 0;
};

/// Times all ways in turn, so that all see the same machine, and prints the medians.
void measure(const Case& c, std::size_t bytes, std::vector<Way> ways, int runs) {
  for (int i = -1; i < runs; ++i)
    for (Way& way : ways) {
      way.before();
      const double faults = page_faults();
      const auto start = std::chrono::steady_clock::now();
      way.run();
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (i < 0) continue;  // warms up
      way.seconds.push_back(seconds);
      way.faults = page_faults() - faults;
    }
  const double megabytes = static_cast<double>(bytes) / 1e6;
  fmt::print("name={}", c.name);
  for (Way& way : ways) {
    std::nth_element(way.seconds.begin(), way.seconds.begin() + runs / 2, way.seconds.end());
    fmt::print(";{}={:.0f}", way.name, megabytes / way.seconds[static_cast<std::size_t>(runs) / 2]);
    if (way.faults > 0) fmt::print(";{}_faults={:.0f}", way.name, way.faults / megabytes);
  }
  fmt::print("\n");
}

bool run(const Case& c, std::size_t count, int runs, std::size_t jobs) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text_of(c, count), "rows.k", {}, diagnostics);
  const keyword::Block& block = deck.value().blocks()[0];
  const CardLayout layout = layout_of(c);
  const Rows rows = keyword::read_rows(deck.value(), block, layout, diagnostics);
  Rows by_from_chars = rows, by_strtod = rows;
  // Neither knows the D of Fortran.
  std::string plain(block.body);
  std::replace(plain.begin(), plain.end(), 'D', 'E');
  const auto clear = [](Rows& r) {
    std::fill(r.integers.begin(), r.integers.end(), -1);
    std::fill(r.reals.begin(), r.reals.end(), -1.0);
  };
  clear(by_from_chars);
  clear(by_strtod);
  const auto from_chars = [&] { read_by(plain, c, by_from_chars, FromChars()); };
  const auto strtod = [&] { read_by(plain, c, by_strtod, StandardC()); };
  from_chars();
  strtod();
  if (rows.count != count || !diagnostics.sorted().empty() || !same(rows, by_from_chars) || !same(rows, by_strtod)) {
    fmt::print(stderr, "{}: the ways of reading differ\n", c.name);
    return false;
  }
  // As the model does it: straight to where the numbers stay.
  Rows in_pieces = rows;
  const auto pieces = [&] {
    keyword::read_rows_in_pieces(
        deck.value(), block, layout, diagnostics, [](std::size_t) {},
        [&](std::size_t first, const Rows& piece) {
          std::copy_n(piece.integers.data(), piece.count * rows.integer_columns,
                      in_pieces.integers.data() + first * rows.integer_columns);
          std::copy_n(piece.reals.data(), piece.count * rows.real_columns,
                      in_pieces.reals.data() + first * rows.real_columns);
        });
  };
  clear(in_pieces);
  pieces();
  if (!same(rows, in_pieces)) {
    fmt::print(stderr, "{}: rows in pieces differ\n", c.name);
    return false;
  }
  std::size_t lines = 0;
  const auto whole = [&] { static_cast<void>(keyword::read_rows(deck.value(), block, layout, diagnostics)); };
  const auto with = [&](std::size_t limit, const auto& way) {
    return [&way, limit] {
      const JobLimit one(limit);
      way();
    };
  };
  measure(c, block.body.size(),
          {{"pieces", with(1, pieces)},
           {"pieces_threads", with(jobs, pieces)},
           {"rows", with(1, whole)},
           {"rows_fresh", with(1, whole), [] { malloc_trim(0); }},
           {"from_chars", from_chars},
           {"strtod", strtod},
           {"memchr", [&] { for_each_line(block.body, [&](std::string_view line) { lines += line.size() & 1; }); }}},
          runs);
  return lines < block.body.size();
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 300000, runs = argc > 2 ? std::atoi(argv[2]) : 7;
  const int jobs = argc > 3 ? std::atoi(argv[3]) : 2;
  if (argc > 4 || count < 1 || runs < 1 || jobs < 1) {
    fmt::print(stderr, "usage: gapcheck_reading_bench [ROWS] [RUNS] [JOBS]\n");
    return 2;
  }
  // Freed memory stays with the process, so that page faults are counted where they are meant to be.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  for (const Case& c : cases)
    if (!run(c, static_cast<std::size_t>(count), runs, static_cast<std::size_t>(jobs))) return 1;
  return 0;
}
