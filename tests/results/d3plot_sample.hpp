#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace gapcheck::results {

/// Writes small d3plot databases word by word, in every form that the reader must take.
class SampleD3plot {
 public:
  // Form.
  bool wide = false;     ///< words of 8 bytes
  bool swapped = false;  ///< the other byte order
  // Content beside the mesh; zero or false: not there.
  int ndim = 4;
  bool numbering = true, part_ids = true, long_numbering = true, wide_ids = false;
  enum class TenNodes { no, behind_solids, at_the_end } ten_nodes = TenNodes::no;
  bool fluids = false, airbags = false, particles = false, adapted = false;
  std::int64_t extra = 0;
  std::size_t more_nodes = 0;  ///< nodes that no element uses

  static constexpr std::size_t base_nodes = 10;
  [[nodiscard]] std::size_t node_count() const { return base_nodes + more_nodes; }
  /// Ids count down in steps of 3, so that no order is taken for granted.
  [[nodiscard]] std::int64_t node_id(std::size_t i) const {
    return (wide_ids ? std::int64_t{5'000'000'000} : 100) + 3 * static_cast<std::int64_t>(node_count() - i);
  }
  static double coordinate(std::size_t node, unsigned k) { return 0.25 * static_cast<double>(node) - 8.0 * k; }

  /// Up to the end of what the reader needs.
  [[nodiscard]] std::string bytes() {
    out_.clear();
    control();
    front();
    mesh();
    if (numbering) write_numbering();
    if (ndim >= 8) integers({1, 2, 3, 4, 5, 6, 2, 7, 8});  // one rigid body with three nodes and two active ones
    if (adapted) integers({1, 0, 1, 1});
    if (particles) integers({9, 2, 10, 2});
    if (ten_nodes == TenNodes::at_the_end) integers({9, 10, 9, 10});
    return out_;
  }

 private:
  void integer(std::int64_t value) {
    if (wide)
      put(static_cast<std::uint64_t>(value));
    else
      put(static_cast<std::uint32_t>(value));
  }
  void integers(const std::vector<std::int64_t>& values) {
    for (const std::int64_t value : values) integer(value);
  }
  void real(double value) {
    if (wide)
      put(std::bit_cast<std::uint64_t>(value));
    else
      put(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  void id(std::int64_t value) {
    if (wide_ids && !wide)
      put(static_cast<std::uint64_t>(value));
    else
      integer(value);
  }
  template <class Bits>
  void put(Bits bits) {
    char text[sizeof bits];
    std::memcpy(text, &bits, sizeof bits);
    if (swapped)
      for (std::size_t i = 0; i < sizeof bits; ++i) out_ += text[sizeof bits - 1 - i];
    else
      out_.append(text, sizeof bits);
  }

  [[nodiscard]] std::int64_t numbering_words() const {
    if (!numbering) return 0;
    const std::int64_t ids = static_cast<std::int64_t>(node_count()) + 2 + 1 + 2 + 1 + (part_ids ? 3 * 3 : 0);
    return (long_numbering ? 16 : 10) + ids * (wide_ids && !wide ? 2 : 1);
  }

  void control() {
    std::string title = "sample of a database";
    title.resize((wide ? 8 : 4) * 10, ' ');
    out_ += title;
    std::vector<std::int64_t> words(64, 0);
    words[11] = wide_ids ? 1001 : 1;
    words[15] = ndim;
    words[16] = static_cast<std::int64_t>(node_count());
    words[17] = 6;
    words[23] = ten_nodes == TenNodes::no ? 2 : -2;
    words[24] = 1;
    words[28] = 1;
    words[29] = 1;
    words[31] = 2;
    words[32] = 1;
    words[37] = particles ? 2 : 0;
    words[39] = numbering_words();
    words[40] = 1;
    words[47] = fluids ? 2 : 0;
    words[50] = adapted ? 2 : 0;
    words[51] = 3;
    words[54] = airbags ? 4002 : 0;
    words[57] = extra;
    for (std::size_t i = 10; i < 64; ++i) integer(words[i]);
  }

  void front() {
    for (std::int64_t i = 0; i < extra; ++i) integer(0);
    if (ndim == 5 || ndim == 7) integers({1, 3, 0, 20, 0});
    if (fluids) integers({1, 2});
    if (particles) integers({11, 1, 1, 6, 1, 1, 1, 1, 6, 1, 0});
    if (airbags) {
      integers({2, 1, 99, 1, 5});
      for (int i = 0; i < 9 * 4; ++i) integer(32 + i);
    }
  }

  void mesh() {
    for (std::size_t i = 0; i < node_count(); ++i)
      for (unsigned k = 0; k < (ndim == 2 ? 2 : 3); ++k) real(coordinate(i, k));
    integers({1, 2, 3, 4, 5, 6, 7, 8, 1});
    integers({1, 2, 3, 4, 4, 4, 4, 4, 2});
    if (ten_nodes == TenNodes::behind_solids) integers({9, 10, 9, 10});
    integers({8, 7, 6, 5, 4, 3, 2, 1, 3});
    integers({9, 10, 1, 120000, 1875, 2});
    integers({1, 2, 3, 4, 3});
    integers({5, 6, 7, 7, 1});
  }

  void write_numbering() {
    integers({long_numbering ? -1 : 1, 20, 30, 40, 50});
    integers({static_cast<std::int64_t>(node_count()), 2, 1, 2, 1});
    if (long_numbering) integers({60, 70, 80, 3, 0, 3});
    for (std::size_t i = 0; i < node_count(); ++i) id(node_id(i));
    for (const std::int64_t i : {501, 502, 601, 701, 702, 801}) id(i);
    if (part_ids)
      for (const std::int64_t i : {30, 10, 20, 10, 20, 30, 2, 3, 1}) id(i);
  }

  std::string out_;
};

}  // namespace gapcheck::results
