#include "lsp/scope.hpp"

#include <algorithm>
#include <utility>

namespace gapcheck::app::lsp {
namespace {

std::shared_ptr<const keyword::Deck> deck_of_nothing() {
  static const auto deck = [] {
    Diagnostics ignored;
    auto read = keyword::read_deck_text("*END\n", "", {}, ignored);
    return read ? std::make_shared<const keyword::Deck>(std::move(read).value())
                : std::make_shared<const keyword::Deck>();
  }();
  return deck;
}

}  // namespace

Scope::Scope() : deck_(deck_of_nothing()) {}

Scope::Scope(std::shared_ptr<const keyword::Deck> deck, FileIndex file)
    : deck_(std::move(deck)), file_(file), whole_(true) {
  for (const keyword::Block& block : deck_->blocks())
    if (block.file == file_) blocks_.push_back(&block);
}

std::set<std::int64_t> Scope::offsets() const {
  std::set<std::int64_t> offsets;
  const auto add = [&](keyword::TransformIndex transform) {
    for (const std::int64_t offset : deck_->transform(transform).offset) offsets.insert(offset);
  };
  // Nodes and elements may have their own.
  if (whole_) add(deck_->file(file_).of_mesh);
  if (!blocks_.empty()) add(blocks_.front()->transform), add(blocks_.back()->transform);
  offsets.erase(0);
  return offsets;
}

keyword::Block Scope::block(const Keyword& keyword) const {
  keyword::Block block;
  // The deck may be a little older than the text: the last block before the line has the parameters in sight.
  const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), keyword.line + 1,
                                      [](std::uint32_t line, const keyword::Block* each) { return line < each->line; });
  if (after != blocks_.begin()) {
    const keyword::Block& known = **std::prev(after);
    block.transform = known.transform;
    block.scope = known.scope;
    block.order = known.order;
  }
  block.name = keyword.name;
  block.format = keyword.format;
  block.line = keyword.line + 1;
  block.file = file_;
  return block;
}

}  // namespace gapcheck::app::lsp
