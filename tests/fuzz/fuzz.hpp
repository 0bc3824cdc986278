#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::fuzz {

/// A function under test. It must neither crash nor hang nor need more memory than a small multiple of the input.
struct Target {
  std::string_view name;
  void (*run)(std::string_view input);
};

/// All that are linked into this program.
[[nodiscard]] std::vector<Target>& targets();

/// Makes a target known before main().
struct Registration {
  explicit Registration(const Target& target) { targets().push_back(target); }
};

/// A broken promise of the library is a find like any crash.
void require(bool holds);

/// An input of several texts: lines of five equals signs are between them. Never empty.
[[nodiscard]] std::vector<std::string_view> parts(std::string_view input);

/// The first line of an input, and what follows it.
struct Headed {
  std::string_view head, rest;
};
[[nodiscard]] Headed headed(std::string_view input);

/// A folder for what can only be read from files. TMPDIR says where; with a disk in memory nothing waits.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string file(std::string_view name) const { return path_ + "/" + std::string(name); }
  /// Replaces a file; returns its path.
  std::string write(std::string_view name, std::string_view bytes) const;
  /// Removes everything in it.
  void clear() const;

 private:
  std::string path_;
};

}  // namespace gapcheck::fuzz

/// GAPCHECK_FUZZ_TARGET(name) { … } defines a target, which takes a std::string_view `input`.
#define GAPCHECK_FUZZ_TARGET(name)                                                     \
  static void fuzz_##name(std::string_view input);                                     \
  static const gapcheck::fuzz::Registration name##_registration({#name, fuzz_##name}); \
  static void fuzz_##name(std::string_view input)
