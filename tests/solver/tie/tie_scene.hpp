#pragma once
#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "solver/run_scene.hpp"

namespace gapcheck::solver {

/// Decks of parts that are tied to one another: meshes in boxes, all of E = 1, density 1, without lateral contraction.
class TieDeck {
 public:
  struct Grid {
    int part = 1;
    Vector corner = Vector::Zero(), size = Vector::Ones();  ///< size in z: the thickness, of shells too
    int nx = 1, ny = 1, nz = 0;                             ///< nz = 0: shells
    std::string material = "*MAT_ELASTIC\n{},1.,1.,0.\n";
  };

  /// Adds a part with a mesh of its own; its nodes have ids from 1000 · part on.
  TieDeck& add(const Grid& g) {
    const bool solid = g.nz > 0;
    const auto id = [&](int i, int j, int k) { return 1000 * g.part + 1 + i + (g.nx + 1) * (j + (g.ny + 1) * k); };
    std::string nodes = "*NODE\n", elements = solid ? "*ELEMENT_SOLID\n" : "*ELEMENT_SHELL\n";
    for (int k = 0; k <= g.nz; ++k)
      for (int j = 0; j <= g.ny; ++j)
        for (int i = 0; i <= g.nx; ++i)
          nodes +=
              fmt::format("{},{:.17g},{:.17g},{:.17g}\n", id(i, j, k), g.corner.x() + i * g.size.x() / g.nx,
                          g.corner.y() + j * g.size.y() / g.ny, g.corner.z() + (solid ? k * g.size.z() / g.nz : 0));
    int element = 1000 * g.part;
    for (int k = 0; k < std::max(1, g.nz); ++k)
      for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i) {
          elements += fmt::format("{},{},{},{},{},{}", ++element, g.part, id(i, j, k), id(i + 1, j, k),
                                  id(i + 1, j + 1, k), id(i, j + 1, k));
          if (solid)
            elements += fmt::format(",{},{},{},{}", id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
                                    id(i, j + 1, k + 1));
          elements += "\n";
        }
    text_ += nodes + elements + fmt::format("*PART\np\n{0},{0},{0}\n", g.part) +
             (solid ? fmt::format("*SECTION_SOLID\n{},1\n", g.part)
                    : fmt::format("*SECTION_SHELL\n{},2,0.8333333333333333,5\n{:.17g},\n", g.part, g.size.z())) +
             fmt::format(fmt::runtime(g.material), g.part);
    return *this;
  }
  /// Nodes of a grid with these indices; negative: all in that direction.
  static std::vector<int> nodes(const Grid& g, int i, int j = -1, int k = -1) {
    std::vector<int> list;
    for (int c = 0; c <= g.nz; ++c)
      for (int b = 0; b <= g.ny; ++b)
        for (int a = 0; a <= g.nx; ++a)
          if ((i < 0 || a == i) && (j < 0 || b == j) && (k < 0 || c == k))
            list.push_back(1000 * g.part + 1 + a + (g.nx + 1) * (b + (g.ny + 1) * c));
    return list;
  }
  TieDeck& hold(const std::vector<int>& nodes, const std::string& freedoms = "1,1,1,1,1,1") {
    text_ += "*BOUNDARY_SPC_NODE\n";
    for (const int node : nodes) text_ += fmt::format("{},0,{}\n", node, freedoms);
    return *this;
  }
  /// A constant force, in equal shares.
  TieDeck& load(const std::vector<int>& nodes, int direction, double force) {
    text_ += "*DEFINE_CURVE\n99\n0.,1.\n1e9,1.\n*LOAD_NODE_POINT\n";
    for (const int node : nodes)
      text_ += fmt::format("{},{},99,{:.17g}\n", node, direction, force / static_cast<double>(nodes.size()));
    return *this;
  }
  /// Ties nodes to a part; `thickness`: -SST and -MST, whose 0.6 together is the tie distance; `scale`: SFS and SFM.
  TieDeck& tie(const std::string& keyword, const std::vector<int>& nodes, int part, double thickness,
               const std::string& optional = "", double scale = 1) {
    const int set = ++sets_;
    text_ += fmt::format("*SET_NODE_LIST\n{}\n", set);
    for (const int node : nodes) text_ += fmt::format("{}\n", node);
    text_ += fmt::format("*CONTACT_{}\n{},{},4,3\n0.\n{},{},{:.17g},{:.17g}\n{}", keyword, set, part, scale, scale,
                         -thickness, -thickness, optional);
    return *this;
  }
  TieDeck& also(const std::string& text) {
    text_ += text;
    return *this;
  }
  [[nodiscard]] std::string text(double end) const {
    return text_ + fmt::format("*CONTROL_TERMINATION\n{:.17g},\n", end);
  }

 private:
  std::string text_;
  int sets_ = 100;
};

/// Mean of something by node over nodes with the given ids.
inline Vector mean_of(const RunScene& scene, const std::vector<Vector>& by_node, const std::vector<int>& ids) {
  const auto& all = scene.read().model.mesh.nodes.id;
  Vector sum = Vector::Zero();
  const std::set<std::int64_t> wanted(ids.begin(), ids.end());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (wanted.contains(all[i])) sum += by_node[i];
  return sum / static_cast<double>(ids.size());
}

}  // namespace gapcheck::solver
