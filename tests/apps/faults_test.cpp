// Signals, limits, and inputs that change while they are read: what was there stays or is complete, exit code 2 says
// that something is missing, and no fault ends a program by a signal of its own. hostile/faults.py has more faults;
// here are those whose results the library must read, and large files.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <string_view>
#include <thread>
#include <vector>

#include "apps/program.hpp"
#include "results/curves/glstat.hpp"
#include "results/d3plot/d3plot_states.hpp"

namespace gapcheck::faults_test {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;

/// How a process ended.
struct Fate {
  int code = -1, signal = 0;
};

/// A program that runs beside the test.
class Running {
 public:
  /// `out`: where its standard output goes.
  Running(const fs::path& folder, const char* program, std::vector<std::string> words, int out) {
    words.insert(words.begin(), program);
    std::vector<char*> list;
    for (std::string& word : words) list.push_back(word.data());
    list.push_back(nullptr);
    process_ = ::fork();
    if (process_ != 0) return;
    // A shell that runs the tests in the background has had interrupts ignored.
    for (const int signal : {SIGINT, SIGHUP, SIGTERM}) ::signal(signal, SIG_DFL);
    const int err = ::open((folder / ".stderr").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(err, 2);
    ::dup2(out, 1);
    if (::chdir(folder.c_str()) == 0) ::execv(program, list.data());
    ::_exit(127);
  }
  void send(int signal) const { ::kill(process_, signal); }
  [[nodiscard]] Fate wait() const {
    int status = 0;
    ::waitpid(process_, &status, 0);
    if (WIFSIGNALED(status)) return {-1, WTERMSIG(status)};
    return {WEXITSTATUS(status), 0};
  }

 private:
  pid_t process_ = -1;
};

constexpr int moments = 12;

/// The programs of program_names.hpp without a shell.
const char* gapcheck_path() {
  const char* other = std::getenv("GAPCHECK_PROGRAM");
  return other != nullptr ? other : GAPCHECK_BINARY;
}
const char* check_c_path() {
  const char* other = std::getenv("CHECK_C_PROGRAM");
  return other != nullptr ? other : CHECK_C_BINARY;
}

class Faults : public Program {
 protected:
  static std::string data(const std::string& name) { return (project / "data" / name).string(); }
  [[nodiscard]] Running start(std::vector<std::string> words, const char* program = gapcheck_path()) const {
    const int null = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    Running running(folder_, program, std::move(words), null);
    ::close(null);
    return running;
  }
  /// How long a call takes, undisturbed.
  [[nodiscard]] Seconds duration(const std::vector<std::string>& words, const char* program = gapcheck_path()) const {
    const auto begin = std::chrono::steady_clock::now();
    const Fate fate = start(words, program).wait();
    EXPECT_EQ(fate.signal, 0);
    EXPECT_NE(fate.code, 127);
    return std::chrono::steady_clock::now() - begin;
  }
  [[nodiscard]] bool fragments() const {
    std::error_code failed;
    for (const fs::path& folder : {folder_, folder_ / "fixed", folder_ / "out"})
      for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
        if (entry->path().filename().string().starts_with(".gapcheck-")) return true;
    return false;
  }
  /// Until a program begins to write: a new file, or `name` is no longer "old".
  void wait_for_writing(const std::string& name, Seconds most) const {
    const auto begin = std::chrono::steady_clock::now();
    std::error_code failed;
    while (!fragments() && fs::file_size(folder_ / name, failed) == 3 &&
           std::chrono::steady_clock::now() - begin < most) {
    }
  }
  /// Two plates of n × n shells that penetrate.
  std::string plates(const std::string& name, int n) const {
    std::string text =
        "*KEYWORD\n*CONTROL_TERMINATION\n1000.0\n*DATABASE_GLSTAT\n0.00001\n*SECTION_SHELL\n1,2\n"
        "1.,1.,1.,1.\n*MAT_ELASTIC\n1,7.8E-6,210.,0.3\n*PART\na\n1,1,1\n*PART\nb\n2,1,1\n"
        "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n*NODE\n";
    for (int plate = 0; plate < 2; ++plate)
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
          text += std::to_string(1 + j + i * (n + 1) + plate * (n + 1) * (n + 1)) + "," + std::to_string(i * 5) + "," +
                  std::to_string(j * 5) + "," + (plate == 0 ? "0." : "0.9") + "\n";
    text += "*ELEMENT_SHELL\n";
    for (int plate = 0, id = 1; plate < 2; ++plate)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j, ++id) {
          const int corner = 1 + j + i * (n + 1) + plate * (n + 1) * (n + 1);
          text += std::to_string(id) + "," + std::to_string(plate + 1);
          for (const int node : {corner, corner + n + 1, corner + n + 2, corner + 1})
            text += "," + std::to_string(node);
          text += "\n";
        }
    return file(name, text + "*END\n");
  }
  /// A log of some megabytes with a list of penetrations.
  std::string long_log(const std::string& name, std::size_t bytes) const {
    const std::string fixture = content(fixtures / "smp/messag");
    std::string text;
    while (text.size() < bytes) text += fixture;
    return file(name, text);
  }
};

std::string call(std::string words) {
  words.replace(0, 1, words.front() == 'G' ? GAPCHECK_PROGRAM : CHECK_C_PROGRAM);
  for (const auto& [name, deck] : {std::pair(" D2", "triangle.k"), std::pair(" D", "two_plates.k")})
    if (const auto at = words.find(name); at != std::string::npos)
      words.replace(at, std::strlen(name), " '" + (fs::path(GAPCHECK_ROOT) / "data" / deck).string() + "'");
  return words;
}

TEST_F(Faults, AClosedStandardOutputIsNotTheNextFile) {
  const Ended run = shell(call("G run D -o out --cycles 1") + " >&- 2>&-");
  EXPECT_EQ(run.code, 2);
  for (const char* name : {"messag", "d3hsp", "glstat", "rcforc", "d3plot"})
    EXPECT_EQ(content(folder_ / "out" / name).find("Ended after"), std::string::npos) << name;
}

TEST_F(Faults, AnInterruptedAuditLeavesOldFilesOrCompleteOnes) {
  plates("p.k", 100);
  const std::vector<std::string> words{"audit",  "p.k", "--format", "json", "--output", "a", "--html",           "b",
                                       "--vtu",  "c",   "--sets",   "d",    "--key",    "e", "--write-baseline", "f",
                                       "--quiet"};
  const Seconds whole = duration(words);
  std::map<std::string, std::string> complete;
  for (const char* name : {"b", "c", "d", "e", "f"}) complete[name] = content(folder_ / name);
  int interrupted = 0;
  for (int i = 0; i < moments; ++i) {
    for (const auto& entry : complete) file(entry.first, "old");
    file("a", "old");
    const Running audit = start(words);
    if (i % 2 == 0) {
      std::this_thread::sleep_for(whole * i / moments);
    } else {
      wait_for_writing("b", 10 * whole);
      std::this_thread::sleep_for(std::chrono::microseconds(200 * i));
    }
    const int signal = std::array{SIGTERM, SIGINT, SIGHUP}[static_cast<std::size_t>(i % 3)];
    audit.send(signal);
    const Fate fate = audit.wait();
    EXPECT_TRUE(fate.signal == signal || fate.code == 1 || fate.code == 0) << fate.code << ' ' << fate.signal;
    interrupted += fate.signal == signal ? 1 : 0;
    for (const auto& [name, text] : complete) {
      const std::string now = content(folder_ / name);
      EXPECT_TRUE(now == "old" || now == text) << name << " at moment " << i;
    }
    const std::string json = content(folder_ / "a");
    EXPECT_TRUE(json == "old" || json.ends_with("}\n")) << i;
    EXPECT_FALSE(fragments()) << i;
  }
  EXPECT_GE(interrupted, moments / 4);
}

TEST_F(Faults, AnInterruptedRunEndsWithItsLastState) {
  plates("p.k", 6);
  int ended = 0;
  for (int i = 0; i < moments; ++i) {
    fs::remove_all(folder_ / "out");
    const Running run = start({"run", "p.k", "-o", "out", "--quiet"});
    // Every second one once it writes: a busy machine may need long to begin.
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (i % 2 != 0 && !fs::exists(folder_ / "out/messag") && std::chrono::steady_clock::now() < limit)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(10 * i));
    const int signal = i % 4 < 2 ? SIGTERM : SIGINT;
    const auto sent = std::chrono::steady_clock::now();
    run.send(signal);
    const Fate fate = run.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(10));
    if (fate.signal == signal) {
      EXPECT_FALSE(fs::exists(folder_ / "out/messag")) << "killed before it began, or not at all";
      continue;
    }
    ++ended;
    EXPECT_EQ(fate.code, 2);
    EXPECT_NE(content(folder_ / ".stderr").find(signal == SIGTERM ? "terminated by SIGTERM" : "terminated by SIGINT"),
              std::string::npos);
    for (const char* log : {"messag", "d3hsp"}) {
      const std::string text = content(folder_ / "out" / log);
      EXPECT_NE(text.find(" *** terminated by a signal ***"), std::string::npos) << log;
      EXPECT_TRUE(text.ends_with("E r r o r   t e r m i n a t i o n\n")) << log;
    }
    const auto glstat = results::read_glstat(content(folder_ / "out/glstat"));
    const auto plot = results::D3plotStates::open((folder_ / "out/d3plot").string());
    ASSERT_TRUE(plot.ok() && plot.value().size() > 0 && !glstat.empty());
    EXPECT_NEAR(plot.value().times().back(), glstat.back().time, 1e-4 * glstat.back().time) << "the last state";
  }
  EXPECT_GE(ended, moments / 4);
}

TEST_F(Faults, InputsThatBecomeShorterWhileTheyAreRead) {
  const std::string log = content(folder_ / long_log("messag", 8'000'000));
  const std::string deck = content(folder_ / plates("p.k", 100));
  struct Reading {
    const char* program;
    std::vector<std::string> words;
    const char* input;
  };
  const std::vector<Reading> readings{{gapcheck_path(), {"audit", "p.k", "--quiet"}, "p.k"},
                                      {gapcheck_path(), {"messag", "messag", "--quiet"}, "messag"},
                                      {check_c_path(), {"messag"}, "messag"},
                                      {gapcheck_path(), {"fix", "p.k", "-o", "fixed", "--quiet"}, "p.k"}};
  for (const Reading& reading : readings) {
    for (const auto& [name, text] : {std::pair("p.k", &deck), std::pair("messag", &log)}) file(name, *text);
    const Seconds whole = std::min(duration(reading.words, reading.program), Seconds(4));
    for (int i = 0; i < moments; ++i) {
      file(reading.input, std::string_view(reading.input) == "p.k" ? deck : log);
      fs::remove_all(folder_ / "fixed");
      const Running running = start(reading.words, reading.program);
      std::this_thread::sleep_for(whole * i / moments);
      fs::resize_file(folder_ / reading.input, 4096);
      const Fate fate = running.wait();
      EXPECT_EQ(fate.signal, 0) << reading.program << ' ' << reading.words[0] << " at moment " << i;
      EXPECT_LE(fate.code, 2);
    }
  }
}

TEST_F(Faults, FixRefusesADeckThatHasChanged) {
  const std::string deck = content(folder_ / plates("p.k", 30));
  const std::vector<std::string> words{"fix", "p.k", "-o", "fixed", "--quiet"};
  const Seconds whole = duration(words);
  const std::string fixed = content(folder_ / "fixed/p.k");
  ASSERT_FALSE(fixed.empty());
  int refused = 0;
  for (int i = 0; i < moments; ++i) {
    file("p.k", deck);
    file("fixed/p.k", "old");
    const Running fix = start(words);
    std::this_thread::sleep_for(whole * i / moments);
    std::ofstream(folder_ / "p.k", std::ios::app) << "$ one more line\n";
    const Fate fate = fix.wait();
    const std::string now = content(folder_ / "fixed/p.k");
    if (fate.code == 2) {
      ++refused;
      EXPECT_EQ(now, "old") << i;
      EXPECT_NE(content(folder_ / ".stderr").find("p.k: was changed while gapcheck worked on it"), std::string::npos);
    } else {
      EXPECT_TRUE(now == fixed || now == fixed + "$ one more line\n") << i << " changed before it was read, or after";
    }
    EXPECT_FALSE(fragments());
  }
  EXPECT_GE(refused, moments / 4);
}

TEST_F(Faults, WithoutThreads) {
  const bool root = ::geteuid() == 0;
  if (root && ::access("/usr/bin/setpriv", X_OK) != 0) GTEST_SKIP() << "root has no limit of processes";
  const std::string other = root ? "setpriv --reuid 65534 --regid 65534 --clear-groups --bounding-set=-all " : "";
  // Large enough for several pieces of work in each loop.
  plates("p.k", 150);
  fs::permissions(folder_, fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
  for (const char* words :
       {"G audit p.k --list --jobs 1", "G audit D --jobs 1 --quiet", "G fix D --dry-run --jobs 1", "C --deck p.k -help",
        "G run p.k -o /dev/null/x --cycles 1 --jobs 1", "G compare p.k D --jobs 1"}) {
    const Ended run = shell(other + "prlimit --nproc=1 " + call(words));
    const Ended free = shell(call(words));
    EXPECT_EQ(run.code, free.code) << words << ": " << run.err;
    EXPECT_TRUE(run.out == free.out) << words;
    EXPECT_EQ(run.err, free.err) << words;
  }
  const Ended refused = shell(other + "prlimit --nproc=1 " + call("G audit p.k --jobs 4"));
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("with --jobs 1 none is needed"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace gapcheck::faults_test
