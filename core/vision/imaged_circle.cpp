#include "core/vision/imaged_circle.hpp"

#include "core/math/so3.hpp"

namespace articam::vision {

template <class S>
Result<Mat<S, 2, 6>> imaged_centre_interaction_matrix(const Circle<S>& circle) noexcept {
  const auto s = imaged_centre(circle);
  if (!s.ok()) return s.status();
  const auto& [c, n, r] = circle;
  const S r2 = r * r;
  const S m_z = c.z() * c.z() + r2 * (n.z() * n.z() - S(1));

  Mat<S, 3, 3> dM_dc = c.z() * Mat<S, 3, 3>::Identity();  // c_z I + c e3^T
  dM_dc.col(2) += c;
  Mat<S, 3, 3> dM_dn = r2 * n.z() * Mat<S, 3, 3>::Identity();  // r^2 (n_z I + n e3^T)
  dM_dn.col(2) += r2 * n;

  Mat<S, 2, 3> ds_dM;
  ds_dM << S(1), S(0), -s.value().x(), S(0), S(1), -s.value().y();
  ds_dM /= m_z;

  // The camera's twist (v, w) moves c by -v - w x c and turns n by -w x n.
  Mat<S, 2, 6> L;
  L.template leftCols<3>() = -ds_dM * dM_dc;
  L.template rightCols<3>() = ds_dM * (dM_dc * math::hat<S>(c) + dM_dn * math::hat<S>(n));
  return L;
}

template Result<Mat<float, 2, 6>> imaged_centre_interaction_matrix(const Circle<float>&) noexcept;
template Result<Mat<double, 2, 6>> imaged_centre_interaction_matrix(const Circle<double>&) noexcept;

}  // namespace articam::vision
