#include "lsp/text.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"
#include "keyword/scan.hpp"

namespace gapcheck::app::lsp {
namespace {

/// Small enough to be copied and checked again for every key, large enough that there are few of them.
constexpr std::size_t piece_size = std::size_t{1} << 16;

/// Cuts a text behind line ends.
std::vector<std::string_view> cut(std::string_view bytes) {
  std::vector<std::string_view> pieces;
  while (!bytes.empty()) {
    const std::size_t newline = bytes.find('\n', std::min(piece_size, bytes.size()) - 1);
    const std::size_t end = newline == std::string_view::npos ? bytes.size() : newline + 1;
    pieces.push_back(bytes.substr(0, end));
    bytes.remove_prefix(end);
  }
  return pieces;
}

}  // namespace

std::string_view next_line(std::string_view bytes, std::size_t offset, std::size_t& next) {
  return keyword::line_at(bytes, offset, next);
}

Piece::Piece(std::string text) : bytes(std::move(text)) {
  for (std::size_t at = 0; at < bytes.size();) {
    if (bytes[at] == '*') {
      marks.push_back({newlines, at});
      rows = 0;
    } else if (bytes[at] != '$') {
      ++rows;
    }
    const std::size_t newline = bytes.find('\n', at);
    if (newline == std::string::npos) return;
    at = newline + 1;
    if (++newlines % step == 0) starts.push_back(at);
  }
}

Text::Text(std::string_view bytes) {
  const std::vector<std::string_view> parts = cut(bytes);
  std::vector<std::shared_ptr<const Piece>> pieces(parts.size());
  parallel_for(parts.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) pieces[i] = std::make_shared<const Piece>(std::string(parts[i]));
  });
  *this = Text(std::move(pieces));
}

Text::Text(std::vector<std::shared_ptr<const Piece>> pieces) : pieces_(std::move(pieces)) {
  first_lines_.reserve(pieces_.size());
  for (const auto& piece : pieces_) {
    first_lines_.push_back(newlines_);
    newlines_ += piece->newlines;
    size_ += piece->bytes.size();
  }
}

Text::Spot Text::start_of(std::uint32_t line) const {
  if (pieces_.empty()) return {};
  const auto after = std::upper_bound(first_lines_.begin(), first_lines_.end(), line);
  Spot at{static_cast<std::size_t>(after - first_lines_.begin()) - 1, 0};
  const Piece& piece = *pieces_[at.piece];
  const std::string& bytes = piece.bytes;
  std::uint32_t left = line - first_lines_[at.piece];
  if (const std::size_t steps = std::min<std::size_t>(left / Piece::step, piece.starts.size()); steps > 0) {
    at.offset = piece.starts[steps - 1];
    left -= static_cast<std::uint32_t>(steps) * Piece::step;
  }
  for (; left > 0; --left) {
    const std::size_t newline = bytes.find('\n', at.offset);
    if (newline == std::string::npos) return {at.piece, bytes.size()};
    at.offset = newline + 1;
  }
  return at;
}

std::string_view Text::line(std::uint32_t number) const {
  std::string_view found;
  for_each_line(number, number + 1, [&](std::uint32_t, std::string_view line) {
    found = line;
    return true;
  });
  return found;
}

std::string_view Text::line_end(std::uint32_t number) const {
  for (number = std::min(number, newlines_);; --number) {
    const Spot at = start_of(number);
    std::size_t next = 0;
    const std::string_view bytes = pieces_.empty() ? std::string_view() : pieces_[at.piece]->bytes;
    if (at.offset < bytes.size()) static_cast<void>(next_line(bytes, at.offset, next));
    if (next > 0 && bytes[next - 1] == '\n') return bytes.substr(0, next).ends_with("\r\n") ? "\r\n" : "\n";
    if (number == 0) return "\n";
  }
}

Text::Spot Text::spot(Place place) const {
  if (pieces_.empty()) return {};
  if (place.line > newlines_) return {pieces_.size() - 1, pieces_.back()->bytes.size()};
  Spot at = start_of(place.line);
  const std::string_view bytes = pieces_[at.piece]->bytes;
  if (at.offset < bytes.size()) {
    std::size_t next = 0;
    at.offset += std::min<std::size_t>(place.byte, next_line(bytes, at.offset, next).size());
  }
  return at;
}

Text Text::edited(Place begin, Place end, std::string_view replacement) const {
  const Spot from = spot(begin), to = spot(std::max(begin, end));
  std::string joined;
  if (!pieces_.empty()) joined = pieces_[from.piece]->bytes.substr(0, from.offset);
  joined += replacement;
  if (!pieces_.empty()) joined += std::string_view(pieces_[to.piece]->bytes).substr(to.offset);
  // Without a line end the joined lines go on in the next piece.
  std::size_t behind = to.piece + 1;
  if (!joined.empty() && joined.back() != '\n' && behind < pieces_.size()) joined += pieces_[behind++]->bytes;
  const auto at = [this](std::size_t i) { return pieces_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::vector<std::shared_ptr<const Piece>> pieces(pieces_.begin(), at(std::min(from.piece, pieces_.size())));
  for (const std::string_view part : cut(joined)) pieces.push_back(std::make_shared<const Piece>(std::string(part)));
  if (behind < pieces_.size()) pieces.insert(pieces.end(), at(behind), pieces_.end());
  return Text(std::move(pieces));
}

std::string Text::bytes() const {
  std::string all;
  all.reserve(size_);
  for (const auto& piece : pieces_) all += piece->bytes;
  return all;
}

}  // namespace gapcheck::app::lsp
