#include "model/entity/output.hpp"

#include <algorithm>

namespace gapcheck::model {

std::vector<Output::Note> Output::all_notes() const {
  std::vector<Note> all = notes;
  if (unwritten.empty()) return all;
  std::vector<std::string> names;
  for (const Unwritten& file : unwritten)
    if (std::find(names.begin(), names.end(), file.name) == names.end()) names.push_back(file.name);
  std::string text = "the deck asks for files that a run does not write: ";
  for (std::size_t i = 0; i < names.size(); ++i) text += (i > 0 ? ", " : "") + names[i];
  all.push_back({unwritten.front().place, std::move(text)});
  return all;
}

}  // namespace gapcheck::model
