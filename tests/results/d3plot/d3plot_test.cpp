#include "results/d3plot/d3plot.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>

#include "results/d3plot_sample.hpp"

namespace gapcheck::results::d3plot_test {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

D3plot must_read(const std::string& bytes) {
  const auto plot = read_d3plot_bytes(bytes, "sample");
  EXPECT_TRUE(plot.ok()) << (plot.ok() ? "" : plot.error().message);
  return plot.ok() ? plot.value() : D3plot{};
}

std::string problem_of(const std::string& bytes) {
  const auto plot = read_d3plot_bytes(bytes, "sample");
  return plot.ok() ? "" : plot.error().message;
}

template <std::size_t N>
bool same(const D3plot::Elements<N>& a, const D3plot::Elements<N>& b) {
  return a.ids == b.ids && a.nodes == b.nodes && a.parts == b.parts;
}

bool same(const D3plot& a, const D3plot& b) {
  return a.node_ids == b.node_ids && a.coordinates == b.coordinates && same(a.solids, b.solids) &&
         same(a.thick_shells, b.thick_shells) && same(a.beams, b.beams) && same(a.shells, b.shells) &&
         same(a.particles, b.particles);
}

template <std::size_t N>
void expect_sound(const D3plot::Elements<N>& elements, const D3plot& plot) {
  ASSERT_EQ(elements.ids.size(), elements.nodes.size());
  ASSERT_EQ(elements.ids.size(), elements.parts.size());
  for (const auto& nodes : elements.nodes)
    for (const std::uint32_t node : nodes) ASSERT_LT(node, plot.node_ids.size());
}

/// What every result that is no error must hold.
void expect_sound(const D3plot& plot) {
  ASSERT_EQ(plot.node_ids.size(), plot.coordinates.size());
  ASSERT_FALSE(plot.node_ids.empty());
  const std::set<std::int64_t> ids(plot.node_ids.begin(), plot.node_ids.end());
  ASSERT_EQ(ids.size(), plot.node_ids.size());
  ASSERT_GT(*ids.begin(), 0);
  for (const auto& x : plot.coordinates)
    for (const double value : x) ASSERT_TRUE(std::isfinite(value));
  expect_sound(plot.solids, plot);
  expect_sound(plot.thick_shells, plot);
  expect_sound(plot.beams, plot);
  expect_sound(plot.shells, plot);
  expect_sound(plot.particles, plot);
}

void expect_sample(const SampleD3plot& sample, const D3plot& plot) {
  EXPECT_EQ(plot.title, "sample of a database");
  EXPECT_EQ(plot.word_bytes, sample.wide ? 8 : 4);
  ASSERT_EQ(plot.node_ids.size(), sample.node_count());
  for (std::size_t i = 0; i < plot.node_ids.size(); ++i) {
    EXPECT_EQ(plot.node_ids[i], sample.numbering ? sample.node_id(i) : static_cast<std::int64_t>(i) + 1);
    for (unsigned k = 0; k < 3; ++k)
      EXPECT_EQ(plot.coordinates[i][k], sample.ndim == 2 && k == 2 ? 0 : SampleD3plot::coordinate(i, k));
  }
  using Ids = std::vector<std::int64_t>;
  const auto ids = [&](const Ids& given, const Ids& counted) { return sample.numbering ? given : counted; };
  const auto parts = [&](Ids numbers) {
    constexpr std::int64_t names[] = {30, 10, 20};
    if (sample.numbering && sample.part_ids)
      for (auto& number : numbers) number = names[number - 1];
    return numbers;
  };
  EXPECT_EQ(plot.solids.ids, ids({501, 502}, {1, 2}));
  EXPECT_EQ(plot.solids.parts, parts({1, 2}));
  ASSERT_EQ(plot.solids.nodes.size(), 2U);
  EXPECT_EQ(plot.solids.nodes[1], (std::array<std::uint32_t, 8>{0, 1, 2, 3, 3, 3, 3, 3}));
  EXPECT_EQ(plot.thick_shells.ids, ids({801}, {1}));
  EXPECT_EQ(plot.thick_shells.parts, parts({3}));
  EXPECT_EQ(plot.thick_shells.nodes[0], (std::array<std::uint32_t, 8>{7, 6, 5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(plot.beams.ids, ids({601}, {1}));
  EXPECT_EQ(plot.beams.parts, parts({2}));
  EXPECT_EQ(plot.beams.nodes[0], (std::array<std::uint32_t, 2>{8, 9}));
  EXPECT_EQ(plot.shells.ids, ids({701, 702}, {1, 2}));
  EXPECT_EQ(plot.shells.parts, parts({3, 1}));
  EXPECT_EQ(plot.shells.nodes[1], (std::array<std::uint32_t, 4>{4, 5, 6, 6}));
  if (!sample.particles) return;
  EXPECT_EQ(plot.particles.ids, (Ids{plot.node_ids[8], plot.node_ids[9]}));
  EXPECT_EQ(plot.particles.parts, parts({2, 2}));
}

TEST(D3plot, ReadsEveryForm) {
  using TenNodes = SampleD3plot::TenNodes;
  for (const bool wide : {false, true})
    for (const bool swapped : {false, true})
      for (int variant = 0; variant < 64; ++variant)
        for (const TenNodes ten_nodes : {TenNodes::no, TenNodes::behind_solids, TenNodes::at_the_end})
          for (const int ndim : {2, 3, 4, 5, 6, 7, 8, 9}) {
            SampleD3plot sample;
            sample.wide = wide;
            sample.swapped = swapped;
            sample.ndim = ndim;
            sample.ten_nodes = ten_nodes;
            sample.fluids = (variant & 1) != 0;
            sample.airbags = (variant & 2) != 0;
            sample.particles = (variant & 4) != 0;
            sample.adapted = (variant & 8) != 0;
            sample.long_numbering = (variant & 16) != 0;
            sample.part_ids = (variant & 32) != 0;
            sample.extra = variant % 3 * 32;
            SCOPED_TRACE(testing::Message() << wide << swapped << " " << variant << " " << ndim);
            ASSERT_NO_FATAL_FAILURE(expect_sample(sample, must_read(sample.bytes())));
          }
}

TEST(D3plot, CountsUpWhereThereIsNoNumbering) {
  SampleD3plot sample;
  sample.numbering = false;
  expect_sample(sample, must_read(sample.bytes()));
}

TEST(D3plot, ReadsIdsOf64BitsInSinglePrecision) {
  for (const bool swapped : {false, true}) {
    SampleD3plot sample;
    sample.wide_ids = true;
    sample.swapped = swapped;
    expect_sample(sample, must_read(sample.bytes()));
  }
}

TEST(D3plot, EveryTruncationIsAnError) {
  for (const bool wide : {false, true}) {
    SampleD3plot sample;
    sample.wide = wide;
    sample.particles = sample.airbags = true;
    sample.extra = 16;
    const std::string bytes = sample.bytes();
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_NE(problem_of(bytes.substr(0, size)), "") << size << " of " << bytes.size();
    expect_sample(sample, must_read(bytes + std::string(5000, '\0')));
  }
}

TEST(D3plot, AbsurdControlWordsDoNotChangeTheMesh) {
  constexpr std::size_t narbs = 39;  // none is a numbering from 1 on
  for (const bool wide : {false, true})
    for (const bool particles : {false, true}) {
      SampleD3plot sample;
      sample.wide = wide;
      sample.particles = particles;
      const std::string bytes = sample.bytes() + std::string(4096, '\0');
      const D3plot expected = must_read(bytes);
      const std::size_t size = wide ? 8 : 4;
      std::size_t refused = 0;
      for (std::size_t word = 10; word < 64; ++word)
        for (const std::int64_t value :
             {std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, std::int64_t{2}, std::int64_t{3}, std::int64_t{1000},
              std::int64_t{1} << 20, std::int64_t{INT32_MAX}, std::int64_t{INT32_MIN}, std::int64_t{INT64_MAX},
              std::int64_t{INT64_MIN}, std::int64_t{INT64_MAX} / 3 + 1, std::int64_t{1} << 61}) {
          std::string changed = bytes;
          std::memcpy(&changed[word * size], &value, size);
          const auto plot = read_d3plot_bytes(changed, "sample");
          if (!plot.ok()) {
            EXPECT_FALSE(plot.error().message.empty());
            ++refused;
          } else if (word != narbs) {
            EXPECT_TRUE((particles && word == 37) || same(plot.value(), expected)) << "word " << word << " = " << value;
            expect_sound(plot.value());
          }
        }
      EXPECT_GT(refused, 100U);
    }
}

TEST(D3plot, MutationsAreHarmless) {
  std::mt19937 random(7);
  for (int run = 0; run < 20000; ++run) {
    SampleD3plot sample;
    sample.wide = random() % 2 == 0;
    sample.particles = random() % 2 == 0;
    sample.ndim = static_cast<int>(2 + random() % 8);
    std::string bytes = sample.bytes();
    for (auto changes = 1 + random() % 6; changes > 0; --changes) {
      const std::size_t at = random() % 4 == 0 ? random() % 512 : random() % bytes.size();
      bytes[at % bytes.size()] = static_cast<char>(random());
    }
    if (random() % 8 == 0) bytes.resize(random() % bytes.size());
    const auto plot = read_d3plot_bytes(bytes, "sample");
    if (!plot.ok()) continue;
    ASSERT_NO_FATAL_FAILURE(expect_sound(plot.value()));
  }
}

TEST(D3plot, SaysWhatIsWrong) {
  EXPECT_NE(problem_of("").find("empty"), std::string::npos);
  EXPECT_NE(problem_of("*KEYWORD\n*NODE\n").find("not a d3plot"), std::string::npos);
  EXPECT_NE(problem_of("\x1f\x8b\x08 and so on").find("gzip"), std::string::npos);
  SampleD3plot sample;
  std::string bytes = sample.bytes();
  const auto set = [](std::string text, std::size_t word, std::int32_t value) {
    std::memcpy(&text[word * 4], &value, 4);
    return text;
  };
  EXPECT_NE(problem_of(set(bytes, 11, 4)).find("database of type 4"), std::string::npos);
  EXPECT_NE(problem_of(set(bytes, 16, 0)).find("no nodes"), std::string::npos);
  EXPECT_NE(problem_of(set(bytes, 16, -7)).find("-7 nodes"), std::string::npos);
  const std::size_t coordinate = 64, solid = coordinate + 3 * SampleD3plot::base_nodes;
  const std::size_t numbering = solid + 18 + 9 + 6 + 10, node_ids = numbering + 16;
  EXPECT_NE(problem_of(set(bytes, coordinate, 0x7f800000)).find("coordinate of node 130"), std::string::npos);
  EXPECT_NE(problem_of(set(bytes, solid, 11)).find("solid 501 has node number 11 of 10"), std::string::npos);
  EXPECT_NE(problem_of(set(bytes, solid + 8, 4)).find("solid 501 has part number 4 of 3"), std::string::npos);
  EXPECT_NE(problem_of(set(bytes, node_ids, 127)).find("two nodes have the id 127"), std::string::npos);
  EXPECT_NE(problem_of(set(bytes, node_ids, -4)).find("a node has the id -4"), std::string::npos);
  EXPECT_EQ(must_read(set(bytes, solid + 1, 0)).solids.nodes[0][1], 0U);
}

TEST(D3plot, MissingFileAndDirectoryAreErrors) {
  EXPECT_FALSE(read_d3plot("/nonexistent/d3plot").ok());
  const auto directory = read_d3plot(fs::temp_directory_path().string());
  ASSERT_FALSE(directory.ok());
  EXPECT_NE(directory.error().message.find("directory"), std::string::npos);
}

/// Files of one family in a folder of their own.
class Family {
 public:
  Family() : folder_(fs::temp_directory_path() / ("gapcheck_d3plot_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Family() { fs::remove_all(folder_); }
  Family(const Family&) = delete;
  Family& operator=(const Family&) = delete;
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  void remove(const std::string& name) const { fs::remove(folder_ / name); }
  [[nodiscard]] std::string first() const { return (folder_ / "d3plot").string(); }

 private:
  fs::path folder_;
};

TEST(D3plot, GeometryGoesOnInTheNextFiles) {
  for (const bool wide : {false, true}) {
    SampleD3plot sample;
    sample.wide = wide;
    sample.more_nodes = 60000;
    const std::string bytes = sample.bytes();
    const std::size_t block = 512 * (wide ? 8 : 4), piece = bytes.size() / 110 / block * block;
    const Family family;
    std::size_t count = 0;
    for (std::size_t at = 0; at < bytes.size(); at += piece, ++count) {
      const std::string number = count == 0 ? "" : (count < 10 ? "0" : "") + std::to_string(count);
      family.write("d3plot" + number, bytes.substr(at, piece));
    }
    ASSERT_GT(count, 100U);
    const auto plot = read_d3plot(family.first());
    ASSERT_TRUE(plot.ok()) << plot.error().message;
    EXPECT_TRUE(same(plot.value(), must_read(bytes)));
    family.remove("d3plot57");
    EXPECT_FALSE(read_d3plot(family.first()).ok());
    // A file that ends within a block was cut: what follows does not belong behind it.
    family.write("d3plot", bytes.substr(0, bytes.size() / 2 - 1));
    family.write("d3plot01", bytes.substr(bytes.size() / 2 - 1));
    EXPECT_FALSE(read_d3plot(family.first()).ok());
  }
}

TEST(MeshSource, TakesShellsBeforeSolids) {
  SampleD3plot sample;
  sample.particles = true;
  const MeshSource source = mesh_source(must_read(sample.bytes()));
  EXPECT_EQ(source.coordinates.size(), SampleD3plot::base_nodes);
  EXPECT_EQ(source.coordinates.at(sample.node_id(3)), Vector(0.75, -7.25, -15.25));
  EXPECT_EQ(source.parts.at(sample.node_id(0)), 20);  // first shell
  EXPECT_EQ(source.parts.at(sample.node_id(6)), 30);  // second shell
  EXPECT_EQ(source.parts.at(sample.node_id(7)), 30);  // first solid
  EXPECT_EQ(source.parts.at(sample.node_id(8)), 10);  // beam, then particle
}

// Databases that LS-DYNA wrote.

fs::path decks() { return fs::path(GAPCHECK_ROOT) / "../shared/decks"; }

/// Control words as numbers, with nothing but the layout of the file assumed.
std::int64_t control_word(const std::string& bytes, std::size_t word, bool wide) {
  if (wide) {
    std::int64_t value = 0;
    std::memcpy(&value, &bytes[word * 8], 8);
    return value;
  }
  std::int32_t value = 0;
  std::memcpy(&value, &bytes[word * 4], 4);
  return value;
}

TEST(D3plot, RealSetsHaveTheCountsOfTheirHeaders) {
  if (!fs::exists(decks())) GTEST_SKIP() << "../shared/decks is not there";
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(decks())) {
    if (!entry.is_regular_file() || entry.path().filename() != "d3plot") continue;
    SCOPED_TRACE(entry.path().string());
    const auto plot = read_d3plot(entry.path().string());
    ASSERT_TRUE(plot.ok()) << plot.error().message;
    const D3plot& p = plot.value();
    const std::string bytes = contents(entry.path());
    const auto word = [&](std::size_t i) {
      return static_cast<std::size_t>(std::abs(control_word(bytes, i, p.word_bytes == 8)));
    };
    EXPECT_EQ(p.node_ids.size(), word(16));
    EXPECT_EQ(p.solids.ids.size(), word(23));
    EXPECT_EQ(p.beams.ids.size(), word(28));
    EXPECT_EQ(p.shells.ids.size(), word(31));
    EXPECT_EQ(p.particles.ids.size(), word(37));
    EXPECT_EQ(p.thick_shells.ids.size(), word(40));
    expect_sound(p);
    ++count;
  }
  EXPECT_GE(count, 11U);
}

TEST(D3plot, CompressedFileIsRefused) {
  const fs::path path = decks() / "d3plot_lasso/test/test_data/femzip/d3plot.fz";
  if (!fs::exists(path)) GTEST_SKIP() << "../shared/decks/d3plot_lasso is not there";
  const auto plot = read_d3plot(path.string());
  ASSERT_FALSE(plot.ok());
  EXPECT_NE(plot.error().message.find("compressed (FEMZIP)"), std::string::npos) << plot.error().message;
}

/// Rows of fixed columns behind each of the keywords that start with `keyword`; the simplest reader that does for
/// these decks. `only_first`: the other lines of each keyword are something else.
std::vector<std::string> rows(const fs::path& path, const std::string& keyword, bool only_first) {
  std::ifstream stream(path);
  std::vector<std::string> result;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("*"))
      inside = line.starts_with(keyword);
    else if (inside && !line.starts_with("$")) {
      result.push_back(line);
      if (only_first) inside = false;
    }
  }
  return result;
}

double number(const std::string& row, std::size_t column, std::size_t width) {
  return row.size() <= column ? 0 : std::strtod(row.substr(column, width).c_str(), nullptr);
}

void expect_coordinates(const fs::path& deck, const D3plot& plot, double relative) {
  std::map<std::int64_t, std::array<double, 3>> nodes;
  for (std::size_t i = 0; i < plot.node_ids.size(); ++i) nodes[plot.node_ids[i]] = plot.coordinates[i];
  const auto lines = rows(deck, "*NODE", false);
  EXPECT_EQ(lines.size(), nodes.size());
  for (const std::string& row : lines) {
    const auto found = nodes.find(static_cast<std::int64_t>(number(row, 0, 8)));
    ASSERT_NE(found, nodes.end()) << row;
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = number(row, 8 + 16 * k, 16);
      ASSERT_NEAR(found->second[k], expected, relative * std::abs(expected)) << row;
    }
  }
}

template <std::size_t N>
void expect_elements(const std::vector<std::string>& lines, const D3plot& plot, const D3plot::Elements<N>& elements) {
  std::map<std::int64_t, std::size_t> places;
  for (std::size_t i = 0; i < elements.ids.size(); ++i) places[elements.ids[i]] = i;
  EXPECT_EQ(lines.size(), places.size());
  for (const std::string& row : lines) {
    const auto found = places.find(static_cast<std::int64_t>(number(row, 0, 8)));
    ASSERT_NE(found, places.end()) << row;
    ASSERT_EQ(elements.parts[found->second], number(row, 8, 8)) << row;
    for (std::size_t k = 0; k < N; ++k)
      ASSERT_EQ(plot.node_ids[elements.nodes[found->second][k]], number(row, 16 + 8 * k, 8)) << row;
  }
}

TEST(D3plot, BirdStrikeIsItsDeck) {
  const fs::path folder = decks() / "bird_strike_composite";
  if (!fs::exists(folder)) GTEST_SKIP() << "../shared/decks/bird_strike_composite is not there";
  const auto plot = read_d3plot((folder / "d3plot").string());
  ASSERT_TRUE(plot.ok());
  expect_coordinates(folder / "input.k", plot.value(), 1e-7);
  expect_elements(rows(folder / "input.k", "*ELEMENT_SHELL", true), plot.value(), plot.value().shells);
  const auto particles = rows(folder / "input.k", "*ELEMENT_SPH", false);
  ASSERT_EQ(particles.size(), plot.value().particles.ids.size());
  const MeshSource source = mesh_source(plot.value());
  for (const std::string& row : particles)
    ASSERT_EQ(source.parts.at(static_cast<std::int64_t>(number(row, 0, 8))), number(row, 8, 8));
}

TEST(D3plot, TiedPlateIsItsDeck) {
  const fs::path folder = decks() / "tied_plate_with_run";
  if (!fs::exists(folder)) GTEST_SKIP() << "../shared/decks/tied_plate_with_run is not there";
  const auto plot = read_d3plot((folder / "d3plot").string());
  ASSERT_TRUE(plot.ok());
  expect_coordinates(folder / "geometry.k", plot.value(), 1e-15);
  expect_elements(rows(folder / "geometry.k", "*ELEMENT_SOLID", false), plot.value(), plot.value().solids);
}

}  // namespace
}  // namespace gapcheck::results::d3plot_test
