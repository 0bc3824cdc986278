#include "base/system/memory.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace gapcheck::system {
namespace {

/// The allocator is not the C library's. This file is compiled once, for programs with and without sanitizers.
bool own_allocator() {
#if defined(__GLIBC__)
  return ::dlsym(RTLD_DEFAULT, "__asan_init") != nullptr || ::dlsym(RTLD_DEFAULT, "__tsan_init") != nullptr;
#else
  return true;
#endif
}

constexpr std::size_t many = std::size_t{64} << 20;

/// The exit code of a process of its own, since what is tested is for good.
int in_child(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

/// How many pages the system had to provide for the work.
long faults_of(const std::function<void()>& work) {
  rusage before{}, after{};
  ::getrusage(RUSAGE_SELF, &before);
  work();
  ::getrusage(RUSAGE_SELF, &after);
  return after.ru_minflt - before.ru_minflt;
}

void fill_array() {
  const std::vector<char> array(many, 'a');
  asm volatile("" : : "r"(array.data()) : "memory");
}

/// MB of one line of /proc/self/status.
long status_mb(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(name + ":")) return std::stol(line.substr(name.size() + 1)) / 1024;
  return -1;
}

/// The system provides large pages to those who ask, at this moment.
bool large_pages_at_hand() {
  const long faults = faults_of([] {
    char* const memory = take_memory(many);
    for (std::size_t i = 0; i < many; i += 4096) memory[i] = 'a';
    give_back_memory(memory, many);
  });
  return faults < 2048;
}

TEST(Memory, FreedMemoryIsUsedAgain) {
  if (own_allocator()) GTEST_SKIP() << "the allocator is not the C library's";
  const auto faults_of_second = [](bool kept) {
    return in_child([kept] {
      if (kept) keep_freed_memory();
      fill_array();
      return faults_of(fill_array) < 16 ? 0 : 1;
    });
  };
  EXPECT_EQ(faults_of_second(true), 0);
  EXPECT_EQ(faults_of_second(false), 1);
}

TEST(Memory, TheHeapIsInLargePages) {
  if (own_allocator()) GTEST_SKIP() << "the allocator is not the C library's";
  enum Answer { large, small, none_at_hand };
  const int answer = in_child([] {
    keep_freed_memory();
    // What the heap had before belongs to both processes, and is copied page by page.
    const std::vector<char*> old_heap{new char[4 * many]};
    if (!large_pages_at_hand()) return none_at_hand;
    return faults_of(fill_array) < 2048 ? large : small;
  });
  if (answer == none_at_hand) GTEST_SKIP() << "this system has no large pages at hand";
  EXPECT_EQ(answer, large);
}

TEST(Memory, TakesAddressesOnly) {
  if (own_allocator()) GTEST_SKIP() << "the allocator is not the C library's";
  EXPECT_EQ(in_child([] {
              const long before = status_mb("VmRSS");
              keep_freed_memory();
              return before >= 0 && status_mb("VmRSS") < before + 8 ? 0 : 1;
            }),
            0);
}

TEST(Memory, LeavesAddressesToALimitedProcess) {
  if (own_allocator()) GTEST_SKIP() << "the allocator is not the C library's";
  // Enough for all memory of the machine, but not for much beside it.
  const auto machine = static_cast<rlim_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
  EXPECT_EQ(in_child([machine] {
              const rlim_t bytes = (static_cast<rlim_t>(status_mb("VmSize")) << 20) + machine;
              const rlimit limit{bytes, bytes};
              if (::setrlimit(RLIMIT_AS, &limit) != 0) return 2;
              keep_freed_memory();
              char* const file = take_memory(machine / 2);
              fill_array();
              return file != nullptr ? 0 : 1;
            }),
            0);
}

}  // namespace
}  // namespace gapcheck::system
