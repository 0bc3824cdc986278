// Audits a deck and prints its deepest penetrations: audit_deck DECK [COUNT]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <gapcheck/gapcheck.hpp>
#include <numeric>
#include <vector>

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto result = gapcheck::api::audit_deck(argv[1]);
  if (!result) {
    std::fprintf(stderr, "%s: %s\n", result.error().file.c_str(), result.error().message.c_str());
    return 2;
  }
  const gapcheck::api::Report& report = result.value();
  for (const auto& each : report.diagnostics)
    std::fprintf(stderr, "%s:%u: %s\n", each.file.c_str(), static_cast<unsigned>(each.line), each.message.c_str());

  const gapcheck::api::Penetrations& p = report.penetrations;
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p.depth[a] > p.depth[b]; });
  order.resize(std::min<std::size_t>(order.size(), argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 5));

  std::printf("penetrations: %zu, contacts: %zu\n", p.size(), report.contacts.size());
  for (const std::size_t i : order) {
    const double* x = &p.position[3 * i];
    std::printf("contact %lld node %lld depth %.6g of %.6g at (%g, %g, %g)\n",
                static_cast<long long>(report.contacts[p.contact[i]].id), static_cast<long long>(p.node[i]), p.depth[i],
                p.contact_distance[i], x[0], x[1], x[2]);
  }
  return report.complete ? 0 : 2;
}
