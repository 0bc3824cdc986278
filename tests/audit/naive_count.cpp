#include "audit/naive_count.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "base/number.hpp"

namespace gapcheck::audit_test {
namespace {

struct Block {
  std::string name;
  std::vector<std::string> rows;  ///< no comments, no blank lines
  std::uint64_t lines = 0;        ///< no comments
};

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

std::vector<Block> blocks_of(const std::string& path) {
  std::vector<Block> blocks;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.starts_with('$')) continue;
    if (line.starts_with('*')) {
      blocks.push_back({upper(line.substr(1, line.find_first_of(" \t,") - 1)), {}, 0});
      if (blocks.back().name == "END") break;
    } else if (!blocks.empty()) {
      ++blocks.back().lines;
      if (!trimmed(line).empty()) blocks.back().rows.push_back(line);
    }
  }
  return blocks;
}

/// Rows of whole numbers only: the connectivity of an element, not its thickness.
std::uint64_t whole_rows(const Block& block) {
  return static_cast<std::uint64_t>(std::count_if(block.rows.begin(), block.rows.end(), [](const std::string& row) {
    const bool many = row.find_first_of(',') != std::string::npos || trimmed(row).size() > 24;
    return many && row.find('.') == std::string::npos;
  }));
}

std::uint64_t solid_rows(const Block& block) {
  const bool two_lines = !block.rows.empty() && trimmed(block.rows.front()).size() <= 16;
  return block.rows.size() / (two_lines ? 2 : 1);
}

std::uint64_t part_rows(const Block& block) {
  // The heading may be blank.
  if (block.name == "PART") return block.lines / 2;
  if (block.name == "PART_CONTACT") return block.lines / 3;
  return block.name == "PART_INERTIA" || block.name == "PART_COMPOSITE" ? 1 : 0;
}

void add(const Block& block, const std::filesystem::path& folder, NaiveCount& count);

void add_file(const std::filesystem::path& path, NaiveCount& count) {
  for (const Block& block : blocks_of(path.string())) add(block, path.parent_path(), count);
}

void add(const Block& block, const std::filesystem::path& folder, NaiveCount& count) {
  const std::string& name = block.name;
  if (name == "INCLUDE") {
    for (const auto& row : block.rows) add_file(folder / std::string(trimmed(row)), count);
  } else if (name == "NODE") {
    count.nodes += block.rows.size();
  } else if (name.starts_with("ELEMENT_SHELL")) {
    count.shells += whole_rows(block);
  } else if (name == "ELEMENT_SOLID") {
    count.solids += solid_rows(block);
  } else if (name == "ELEMENT_BEAM") {
    count.beams += whole_rows(block);
  } else if (name == "ELEMENT_SPH") {
    count.particles += block.rows.size();
  } else if (name.starts_with("PART")) {
    count.parts += part_rows(block);
  } else if (name.starts_with("CONTACT_") && name != "CONTACT_EXCLUDE_INTERACTION") {
    count.contacts.push_back(name);
  }
}

}  // namespace

NaiveCount naive_count(const std::string& path) {
  NaiveCount count;
  add_file(path, count);
  return count;
}

}  // namespace gapcheck::audit_test
