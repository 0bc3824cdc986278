#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "base/vector.hpp"

namespace gapcheck::bench {

/// Takes the next piece of a deck; the text dies with the call.
using DeckSink = std::function<void(std::string_view)>;

/// Writes nodes, shells and bricks in standard format, fast and without ever holding the whole deck. Ids count from 1;
/// at most 99,999,999 of a kind. Coordinates are written with as many decimals, up to six, as fit sixteen columns.
class DeckWriter {
 public:
  explicit DeckWriter(DeckSink sink) : sink_(std::move(sink)) { text_.reserve(piece + 256); }
  DeckWriter(const DeckWriter&) = delete;
  DeckWriter& operator=(const DeckWriter&) = delete;
  ~DeckWriter() { flush(); }

  /// Keywords and cards as they are, with their line ends.
  void text(std::string_view cards);
  /// A part of that section and of material 1; returns its id.
  int part(int section);
  /// Returns the id of the node.
  int node(const Vector& at);
  void shell(int part, const std::array<int, 4>& nodes);
  void brick(int part, const std::array<int, 8>& nodes);
  /// n × m shells over (n + 1) × (m + 1) nodes, node (i, j) at place(i, j).
  template <class Place>
  void sheet(int part, int n, int m, const Place& place) {
    const int first = nodes_ + 1;
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) node(place(i, j));
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = first + j * (n + 1) + i;
        shell(part, {a, a + 1, a + n + 2, a + n + 1});
      }
  }
  /// n × m × l bricks between (n + 1) × (m + 1) × (l + 1) nodes, node (i, j, k) at place(i, j, k).
  template <class Place>
  void block(int part, int n, int m, int l, const Place& place) {
    const int first = nodes_ + 1, row = n + 1, layer = row * (m + 1);
    for (int k = 0; k <= l; ++k)
      for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) node(place(i, j, k));
    for (int k = 0; k < l; ++k)
      for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
          const int a = first + k * layer + j * row + i, b = a + layer;
          brick(part, {a, a + 1, a + row + 1, a + row, b, b + 1, b + row + 1, b + row});
        }
  }
  void flush();

  [[nodiscard]] int nodes() const { return nodes_; }
  [[nodiscard]] int shells() const { return shells_; }
  [[nodiscard]] int bricks() const { return bricks_; }
  [[nodiscard]] int parts() const { return parts_; }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 20;
  enum class Block { none, nodes, shells, bricks };
  void open(Block block, std::string_view keyword);
  void row_done();

  DeckSink sink_;
  std::string text_;
  Block block_ = Block::none;
  int nodes_ = 0, shells_ = 0, bricks_ = 0, parts_ = 0;
};

}  // namespace gapcheck::bench
