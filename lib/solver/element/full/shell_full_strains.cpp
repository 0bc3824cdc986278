#include "solver/element/full/shell_full_strains.hpp"

namespace gapcheck::solver {

FullStrains full_rates(const FullFrame& frame, const MembraneModes& modes, const Bilinear& v, const Bilinear& m) {
  FullStrains rates;
  Products membrane, bending;
  membrane.add(frame.x, v);
  bending.add(frame.x, m);
  bending.add(frame.n, v);
  rates.membrane = modes.assumed(in_plane(frame, membrane));
  rates.bending = in_plane(frame, bending);
  SideShear shear;
  shear.add(frame.x, m);
  shear.add(v, frame.n);
  const Four xi = shear.mean_xi + point_eta * shear.slope_xi, eta = shear.mean_eta + point_xi * shear.slope_eta;
  rates.zx = frame.xi_x * xi + frame.eta_x * eta;
  rates.yz = frame.xi_y * xi + frame.eta_y * eta;
  return rates;
}

void pull(const FullFrame& frame, const MembraneModes& modes, const FullStrains& resultants, Bilinear& on_v,
          Bilinear& on_m) {
  along_lines(frame, modes.transposed(resultants.membrane)).spread(frame.x, on_v);
  const Products bending = along_lines(frame, resultants.bending);
  bending.spread(frame.x, on_m);
  bending.spread(frame.n, on_v);
  const Four xi = frame.determinant * (resultants.zx * frame.xi_x + resultants.yz * frame.xi_y),
             eta = frame.determinant * (resultants.zx * frame.eta_x + resultants.yz * frame.eta_y);
  const SideShear shear{xi.sum(), (point_eta * xi).sum(), eta.sum(), (point_xi * eta).sum()};
  shear.spread(frame.x, on_m);
  shear.spread_tangent(frame.n, on_v);
}

}  // namespace gapcheck::solver
