// Runs the fuzzed function over files and over fixed mutations of them, so that every compiler and sanitizer can.
//   gapcheck_fuzz_replay [--mutations N] FILE...
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::size_t max_size = std::size_t{1} << 20;

constexpr std::array<std::string_view, 32> tokens{"\n*NODE\n",
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

void run(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace

int main(int argc, char** argv) {
  unsigned long mutations = 100, runs = 0;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--mutations" && i + 1 < argc)
      mutations = std::strtoul(argv[++i], nullptr, 10);
    else
      files.emplace_back(argv[i]);
  }
  if (files.empty()) {
    std::fprintf(stderr, "usage: gapcheck_fuzz_replay [--mutations N] FILE...\n");
    return 2;
  }
  for (const std::string& file : files) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
      std::fprintf(stderr, "gapcheck_fuzz_replay: error: %s cannot be opened\n", file.c_str());
      return 2;
    }
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::mt19937 random(1);
    run(text);
    for (unsigned long i = 0; i < mutations; ++i) run(mutated(text, random));
    runs += mutations + 1;
  }
  std::printf("%lu inputs read\n", runs);
  return 0;
}
