#include <vector>

#include "base/parallel.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {
namespace {

class BruteForce final : public CandidateSearch {
 public:
  [[nodiscard]] std::string_view name() const override { return "brute force"; }
  [[nodiscard]] bool exhaustive() const override { return true; }
  void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const override {
    parallel_for(boxes.size(), 16, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> inside;
      for (std::size_t b = begin; b < end; ++b) {
        inside.clear();
        for (std::uint32_t p = 0; p < points.size(); ++p) {
          const auto x = points[p].array();
          if ((x >= boxes[b].low.array()).all() && (x <= boxes[b].high.array()).all()) inside.push_back(p);
        }
        if (!inside.empty()) sink(static_cast<std::uint32_t>(b), inside);
      }
    });
  }
};

}  // namespace

std::unique_ptr<CandidateSearch> make_brute_force() { return std::make_unique<BruteForce>(); }

}  // namespace gapcheck::contact
