#include "audit/untangle/cut_surface.hpp"

#include <algorithm>

namespace gapcheck::audit {

std::vector<SegmentIndex> CutSurface::around(const model::Mesh& mesh, std::span<const ElementOfKind> elements) const {
  std::vector<SegmentIndex> list;
  for (const ElementOfKind& element : elements) {
    bool any = false;
    for (const NodeIndex n : nodes_of(mesh, element))
      for (const SegmentIndex s : neighbours_.at(n)) {
        any |= segments().element[s.value] == element.second && segments().element_kind[s.value] == element.first;
        list.push_back(s);
      }
    if (!any) return {};
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

}  // namespace gapcheck::audit
