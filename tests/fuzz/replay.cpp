// Runs a fuzz target over files and over fixed mutations of them, so that every compiler and sanitizer can.
//   gapcheck_fuzz_replay TARGET [--mutations N] FILE-OR-FOLDER...
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.hpp"
#include "fuzz.hpp"

namespace gapcheck::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_size = std::size_t{1} << 20;

constexpr std::array<std::string_view, 33> tokens{"\n*NODE\n",
                                                  "\n*ELEMENT_SHELL\n",
                                                  "\n*ELEMENT_SOLID\n",
                                                  "\n*PART\n",
                                                  "\n*SECTION_SHELL\n",
                                                  "\n*SET_NODE_LIST_GENERATE\n",
                                                  "\n*SET_PART_LIST\n",
                                                  "\n*SET_SEGMENT_GENERAL\n",
                                                  "\n*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n",
                                                  "\n*CONTACT_ENTITY\n",
                                                  "\n*PARAMETER\n",
                                                  "\n*PARAMETER_EXPRESSION\n",
                                                  "\n*INCLUDE\n",
                                                  "\n*DEFINE_BOX\n",
                                                  "\n*KEYWORD LONG=Y\n",
                                                  "\n*CONTROL_CONTACT\n",
                                                  "\n*END\n",
                                                  "\n$\n",
                                                  "\n\n",
                                                  "\t",
                                                  ",",
                                                  "&",
                                                  "<1+1>",
                                                  "-1",
                                                  "9223372036854775807",
                                                  "-9223372036854775808",
                                                  "1e30",
                                                  "nan",
                                                  "0",
                                                  "                    ",
                                                  "-----BEGIN PGP MESSAGE-----\n",
                                                  "\n=====\n",
                                                  "99999999"};

std::string mutated(std::string text, std::mt19937& random) {
  for (auto changes = 1 + random() % 4; changes > 0; --changes) {
    const std::size_t at = random() % (text.size() + 1), length = random() % (text.size() - at + 1);
    switch (random() % 6) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, random() % 4 == 0 ? length : random() % 20);
        break;
      case 2:
        text.insert(at, tokens[random() % tokens.size()]);
        break;
      case 3:
        text.insert(random() % (text.size() + 1), text.substr(at, length % 400));
        break;
      case 4:
        if (random() % 4 == 0) text.resize(at);
        break;
      default: {
        const std::string_view token = tokens[random() % tokens.size()];
        text.replace(at, token.size(), token);
        break;
      }
    }
    if (text.size() > max_size) text.resize(max_size);
  }
  return text;
}

/// Files in their order by name, those of folders among them.
std::vector<std::string> files_of(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : fs::directory_iterator(path)) inside.push_back(entry.path().string());
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

int complain(const std::string& what) {
  std::fprintf(stderr, "gapcheck_fuzz_replay: error: %s\n", what.c_str());
  return 2;
}

int usage() {
  std::fprintf(stderr, "usage: gapcheck_fuzz_replay TARGET [--mutations N] FILE-OR-FOLDER...\ntargets:");
  for (const Target& target : targets()) std::fprintf(stderr, " %s", std::string(target.name).c_str());
  std::fprintf(stderr, "\n");
  return 2;
}

/// Runs one file and its mutations.
bool replay(const Target& target, const std::string& file, unsigned long mutations) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return false;
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::mt19937 random(1);
  target.run(text);
  for (unsigned long i = 0; i < mutations; ++i) target.run(mutated(text, random));
  return true;
}

int main_of(const std::vector<std::string>& words) {
  unsigned long mutations = 0;
  std::vector<std::string> paths;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] == "--mutations" && i + 1 < words.size())
      mutations = std::strtoul(words[++i].c_str(), nullptr, 10);
    else
      paths.push_back(words[i]);
  }
  if (paths.empty()) return usage();
  const auto target = std::find_if(targets().begin(), targets().end(),
                                   [&](const Target& known) { return known.name == words.front(); });
  if (target == targets().end()) return usage();
  const JobLimit one_thread(1);
  const std::vector<std::string> files = files_of(paths);
  if (files.empty()) return complain("there are no files");
  for (const std::string& file : files)
    if (!replay(*target, file, mutations)) return complain(file + " cannot be opened");
  std::printf("%lu inputs read\n", files.size() * (mutations + 1));
  return 0;
}

}  // namespace
}  // namespace gapcheck::fuzz

int main(int argc, char** argv) { return gapcheck::fuzz::main_of({argv + (argc > 0 ? 1 : 0), argv + argc}); }
