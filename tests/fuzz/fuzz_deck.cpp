// Any bytes as a deck, read up to the model; what follows a line of equals signs are its includes, 1.k, 2.k, …
#include <string>

#include "fuzz.hpp"
#include "model/model.hpp"

namespace gapcheck::fuzz::deck_target {

GAPCHECK_FUZZ_TARGET(deck) {
  const auto files = parts(input);
  Diagnostics diagnostics;
  keyword::ReadOptions options;
  options.max_include_depth = 0;  // other files are no part of the input
  if (files.size() > 1) {
    static const Folder folder;
    folder.clear();
    options.max_include_depth = 3;
    options.max_files = 10;
    options.max_repeated_bytes = 100'000;
    options.include_directories = {folder.path()};
    for (std::size_t i = 1; i < files.size() && i < 4; ++i) folder.write(std::to_string(i) + ".k", files[i]);
  }
  const auto read = keyword::read_deck_text(std::string(files.front()), "fuzz.k", options, diagnostics);
  if (read) static_cast<void>(model::read_model(read.value(), diagnostics).ok());
  static_cast<void>(diagnostics.sorted());
}

}  // namespace gapcheck::fuzz::deck_target
