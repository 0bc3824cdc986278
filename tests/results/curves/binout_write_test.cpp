#include "results/curves/binout_write.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "results/curves/binout_folder.hpp"

namespace gapcheck::results::binout_write_test {
namespace {

namespace fs = std::filesystem;

class BinoutWrite : public BinoutFolder {
 protected:
  RunResults read() { return read_folder(); }

  FileHeader header_{"a run", "gapcheck 1.2.3"};
};

/// Two contacts, the first a single surface, with numbers that belong to the state.
InterfaceStates contacts_at(int state) {
  InterfaceStates states{0.25 * state, static_cast<std::uint64_t>(10 * state), {}};
  for (const std::int64_t id : {80085, 12}) {
    InterfaceState& contact = states.contacts.emplace_back();
    contact.contact = id;
    contact.single_surface = id == 80085;
    for (const std::size_t side : {0u, 1u}) {
      const double sign = side == 0 ? state : -state;
      contact.force[side] = sign * Vector(1, 2, 3);
      contact.moment[side] = sign * Vector(4, 5, 6e-12);
      contact.energy[side] = contact.single_surface && side == 1 ? 0 : sign / 3;
    }
    contact.friction = state / 7.0;
  }
  return states;
}

void expect_state(const InterfaceStates& read, int state) {
  const InterfaceStates written = contacts_at(state);
  EXPECT_EQ(read.time, written.time);
  ASSERT_EQ(read.contacts.size(), 1u) << "resultants of a single surface are not defined";
  EXPECT_EQ(read.contacts[0].contact, 12);
  for (const std::size_t side : {0u, 1u}) {
    EXPECT_EQ(read.contacts[0].force[side], written.contacts[1].force[side]);
    EXPECT_EQ(read.contacts[0].moment[side], written.contacts[1].moment[side]);
  }
}

TEST_F(BinoutWrite, EveryNumberComesBack) {
  GlobalState global;
  global.cycle = 17;
  double value = 0;
  for (const auto member :
       {&GlobalState::time, &GlobalState::time_step, &GlobalState::kinetic, &GlobalState::internal,
        &GlobalState::springs, &GlobalState::hourglass, &GlobalState::damping, &GlobalState::sliding,
        &GlobalState::external, &GlobalState::total, &GlobalState::ratio, &GlobalState::eroded_internal,
        &GlobalState::eroded_hourglass, &GlobalState::ratio_without_eroded})
    global.*member = (value += 1) / 3;
  global.velocity = {1, -2, 3e-300};
  global.walls = {{1, 0.5}, {2, 0.25}};
  NodeStates nodes{5, 0.125, {}};
  nodes.nodes.push_back(
      {5'000'000'000, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, {13, 14, 15}, {16, 17, 18}, {19, 20, 21}});
  const std::vector<PartState> parts{{3, 1, 2, 3, 4, 5, {6, 7, 8}, {9, 10, 11}}, {1, 12, 13, 14, 15, 16, {}, {}}};
  auto binout = BinoutWriter::create(path(), header_);
  ASSERT_TRUE(binout);
  add_glstat(binout.value(), global);
  add_matsum(binout.value(), 0.5, {{3, "three"}, {1, "one"}}, parts);
  add_nodout(binout.value(), {{5'000'000'000, ""}}, nodes);
  for (const int state : {1, 2}) {
    add_rcforc(binout.value(), {}, contacts_at(state));
    add_sleout(binout.value(), {}, contacts_at(state));
    ASSERT_TRUE(binout.value().file().flush().ok());
  }
  const RunResults run = read();
  EXPECT_EQ(said_, "");
  EXPECT_TRUE(run.missing.empty());
  ASSERT_EQ(run.glstat.size(), 1u);
  const GlobalState& back = run.glstat[0];
  EXPECT_EQ(glstat_text(back), glstat_text([&] {
              GlobalState same = global;
              same.controlled_by = back.controlled_by;
              return same;
            }()));
  EXPECT_EQ(back.velocity, global.velocity);
  EXPECT_EQ(back.ratio_without_eroded, 14.0 / 3);
  ASSERT_EQ(back.walls.size(), 2u);
  EXPECT_EQ(back.walls[1].energy, 0.25);
  EXPECT_EQ(nodout_text(5, 0.125, run.nodout.states.at(0).nodes), nodout_text(5, 0.125, nodes.nodes));
  EXPECT_EQ(matsum_text(0.5, run.matsum.states.at(0).parts), matsum_text(0.5, parts));
  EXPECT_EQ(run.rcforc.single_surface, std::vector<std::int64_t>{80085});
  ASSERT_EQ(run.rcforc.states.size(), 2u);
  expect_state(run.rcforc.states[1], 2);
  ASSERT_EQ(run.sleout.states.size(), 2u);
  EXPECT_EQ(sleout_text(0, 1, run.sleout.states[1].contacts), sleout_text(0, 1, contacts_at(2).contacts));
}

// A run that is killed: whatever is left of the file, every state that was flushed is there, and no other one with
// numbers that are not its own.
TEST_F(BinoutWrite, CutAnywhere) {
  std::vector<std::uintmax_t> sizes;
  {
    auto binout = BinoutWriter::create(path(), header_);
    ASSERT_TRUE(binout);
    for (int state = 1; state <= 4; ++state) {
      add_rcforc(binout.value(), {}, contacts_at(state));
      ASSERT_TRUE(binout.value().file().flush().ok());
      sizes.push_back(fs::file_size(path()));
    }
  }
  std::size_t most = 0;
  // Down to the second state: with one state alone nothing says how many arrays it should have.
  for (std::uintmax_t size = sizes.back(); size >= sizes[0]; --size) {
    fs::resize_file(path(), size);
    const RunResults run = read();
    std::size_t flushed = 0;
    while (flushed < sizes.size() && sizes[flushed] <= size) ++flushed;
    ASSERT_GE(run.rcforc.states.size(), flushed) << size;
    ASSERT_LE(run.rcforc.states.size(), flushed + 1) << size;
    for (std::size_t i = 0; i < run.rcforc.states.size(); ++i)
      expect_state(run.rcforc.states[i], static_cast<int>(i) + 1);
    most = std::max(most, run.rcforc.states.size());
    ASSERT_FALSE(HasFailure()) << size;
  }
  EXPECT_EQ(most, 4u);
}

// Long files are continued; the ids of the first one hold for all.
TEST_F(BinoutWrite, SeveralFiles) {
  {
    auto binout = BinoutWriter::create(path(), header_, {3000});
    ASSERT_TRUE(binout);
    for (int state = 1; state <= 12; ++state) {
      add_rcforc(binout.value(), {}, contacts_at(state));
      ASSERT_TRUE(binout.value().file().flush().ok());
    }
    EXPECT_TRUE(binout.value().file().check_names().ok());
    fs::remove(path() + "%001");
    const Status gone = binout.value().file().check_names();
    ASSERT_FALSE(gone.ok());
    EXPECT_NE(gone.error().file.find("binout0000%001"), std::string::npos);
  }
  EXPECT_TRUE(fs::exists(path() + "%002"));
  const RunResults part = read();
  EXPECT_GT(part.rcforc.states.size(), 2u);
  {
    auto binout = BinoutWriter::create(path(), header_, {3000});
    for (int state = 1; state <= 12; ++state) {
      add_rcforc(binout.value(), {}, contacts_at(state));
      ASSERT_TRUE(binout.value().file().flush().ok());
    }
  }
  const RunResults run = read();
  EXPECT_EQ(said_, "");
  ASSERT_EQ(run.rcforc.states.size(), 12u);
  for (int state = 1; state <= 12; ++state) expect_state(run.rcforc.states[static_cast<std::size_t>(state - 1)], state);
}

TEST_F(BinoutWrite, NoPlaceNoFolderNoName) {
  EXPECT_FALSE(BinoutWriter::create((folder_ / "none" / "binout0000").string(), header_).ok());
  if (fs::exists("/dev/full")) {
    const auto full = BinoutWriter::create("/dev/full", header_);
    ASSERT_FALSE(full.ok());
    EXPECT_NE(full.error().message.find("cannot be written"), std::string::npos);
  }
}

// A disk that fills up while the file grows.
TEST_F(BinoutWrite, ALimitOfTheFileIsReported) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 5000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  auto binout = BinoutWriter::create(path(), header_);
  int failed_at = 0;
  for (int state = 1; state <= 12 && failed_at == 0; ++state) {
    add_rcforc(binout.value(), {}, contacts_at(state));
    if (!binout.value().file().flush().ok()) failed_at = state;
  }
  EXPECT_FALSE(binout.value().file().flush().ok()) << "a failure stays one";
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old);
  EXPECT_GT(failed_at, 1);
  EXPECT_GE(read().rcforc.states.size(), static_cast<std::size_t>(failed_at - 1));
}

}  // namespace
}  // namespace gapcheck::results::binout_write_test
