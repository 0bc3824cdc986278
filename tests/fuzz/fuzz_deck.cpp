// The function under test: any bytes as a deck, read up to the model. It must neither crash nor hang nor need more
// memory than a small multiple of the input.
#include <cstddef>
#include <cstdint>
#include <string>

#include "model/model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gapcheck::Diagnostics diagnostics;
  gapcheck::keyword::ReadOptions options;
  options.max_include_depth = 0;  // other files are no part of the input
  const auto deck = gapcheck::keyword::read_deck_text(std::string(reinterpret_cast<const char*>(data), size), "fuzz.k",
                                                      options, diagnostics);
  if (deck) static_cast<void>(gapcheck::model::read_model(deck.value(), diagnostics).ok());
  static_cast<void>(diagnostics.sorted());
  return 0;
}
