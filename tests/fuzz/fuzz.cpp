#include "fuzz.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>

namespace gapcheck::fuzz {

std::vector<Target>& targets() {
  static std::vector<Target> list;
  return list;
}

void require(bool holds) {
  if (!holds) std::abort();
}

std::vector<std::string_view> parts(std::string_view input) {
  constexpr std::string_view between = "\n=====\n";
  std::vector<std::string_view> list;
  for (std::size_t at = input.find(between); at != std::string_view::npos; at = input.find(between)) {
    list.push_back(input.substr(0, at + 1));
    input.remove_prefix(at + between.size());
  }
  list.push_back(input);
  return list;
}

Headed headed(std::string_view input) {
  const std::size_t end = input.find('\n');
  if (end == std::string_view::npos) return {input, {}};
  return {input.substr(0, end), input.substr(end + 1)};
}

Folder::Folder() {
  path_ = (std::filesystem::temp_directory_path() / "gapcheck_fuzz_XXXXXX").string();
  if (::mkdtemp(path_.data()) == nullptr) {
    std::perror(path_.c_str());
    std::exit(2);
  }
}

Folder::~Folder() {
  std::error_code failed;
  std::filesystem::remove_all(path_, failed);
}

std::string Folder::write(std::string_view name, std::string_view bytes) const {
  const auto close = [](std::FILE* file) { std::fclose(file); };
  std::string to = file(name);
  const std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(to.c_str(), "wb"), close);
  if (stream == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), stream.get()) != bytes.size()) {
    std::perror(to.c_str());
    std::exit(2);
  }
  return to;
}

void Folder::clear() const {
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(path_, failed))
    std::filesystem::remove_all(entry.path(), failed);
}

}  // namespace gapcheck::fuzz
