#pragma once
/// @file  How far a mark may be from its feature, and how likely it is the feature's.

#include <cmath>
#include <limits>

#include "core/math/logarithm.hpp"
#include "core/model/point_jacobian.hpp"
#include "core/tracker/features.hpp"

namespace articam::tracker {

/// Standard deviations beyond what the configuration's covariance and the detector's tell: jerks, as no prediction
/// holds them, and the print's and blur's part in the size. px, and of the logarithm of the area.
template <class S>
inline constexpr S kUnmodelled_px = S(4);
template <class S>
inline constexpr S kUnmodelledSize = S(0.1);

/// A mark beyond this is another's: chi-square of 3 degrees of freedom, exceeded once in 1000.
template <class S>
inline constexpr S kGate = S(16.27);

/// No covariance makes the gate wider than this; what has gone farther is a case for acquisition. With kUnmodelled_px
/// the gate lies between 16 px and this.
template <class S>
inline constexpr S kMaxReach_px = S(160);

/// Sets every visible feature's covariance: A P A^T, P being the configuration's (m, rad). The lens's part in A, a few
/// percent of it, is left out.
template <class M, class S>
void spread_features(const model::Configuration<M, S>& q, const vision::CameraModel<S>& camera,
                     const Mat<S, model::kDof<M>, model::kDof<M>>& P, Features<M, S>& features) noexcept {
  const auto kinematics = model::forward_kinematics<M, S>(q.joints);
  for (std::size_t i = 0; i < features.size(); ++i) {
    Feature<S>& feature = features[i];
    if (!feature.visible) continue;
    const model::MarkerRow& row = M::kMarkers[i];
    const auto circle = circle_in_camera(q.T_cam_obj, kinematics.markers[i], row.outer_diameter_m);
    const auto image = vision::moving_ellipse(circle);
    if (!image.ok() || feature.image.m00_q16 <= 0 || feature.image.m11_q16 <= 0) continue;
    const S per_m00 = S(65536) / static_cast<S>(feature.image.m00_q16),
            per_m11 = S(65536) / static_cast<S>(feature.image.m11_q16);
    Mat<S, 3, 6> L;  // of u and v, px, and of log(m00 m11)
    L << image.value().L.template topRows<2>(), per_m00 * image.value().L.row(2) + per_m11 * image.value().L.row(4);
    L *= camera.focal_px();
    const Mat<S, 3, model::kDof<M>> A = L.lazyProduct(model::point_jacobian<M, S>(kinematics, q.T_cam_obj, row.body));
    const Mat<S, 3, model::kDof<M>> AP = A.lazyProduct(P);
    feature.covariance = AP.template topRows<2>().lazyProduct(A.template topRows<2>().transpose());
    feature.size_variance = AP.row(2).dot(A.row(2));
    const S most = kMaxReach_px<S> * kMaxReach_px<S> / kGate<S>, trace = feature.covariance.trace();
    if (trace > most) feature.covariance *= most / trace;
    if (feature.size_variance > S(1)) feature.size_variance = S(1);
  }
}

/// The farthest that a mark's column and row may be from the feature's and pass the gate, px.
template <class S>
Vec<S, 2> reach_px(const Feature<S>& feature) noexcept {
  constexpr S kLeast = kUnmodelled_px<S> * kUnmodelled_px<S>;
  return {std::sqrt(kGate<S> * (feature.covariance(0, 0) + kLeast)),
          std::sqrt(kGate<S> * (feature.covariance(1, 1) + kLeast))};
}

/// A mark against a feature. The size tells markers of different diameter apart; the ratio of a ring's two edges does
/// not, as the detector seeks one ratio for all rings. With S = A P A^T + R, R the detection's variance and the
/// unmodelled one, and e the distance: -2 ln of the normal density is  e^T S^-1 e + ln det S  and a constant, for the
/// centre and likewise for the size.
template <class S>
struct Innovation {
  S centre{std::numeric_limits<S>::infinity()};  ///< squared Mahalanobis distance of the centres
  S size{};                                      ///< the same of the logarithms of the areas
  S width{};                                     ///< ln det S of both, beyond that of a known configuration
  bool passes() const noexcept { return centre + size < kGate<S>; }
};

/// Of different kinds: infinitely far.
template <class S>
Innovation<S> innovation(const Feature<S>& feature, const vision::Detection& mark) noexcept {
  constexpr S kPixel2 = kUnmodelled_px<S> * kUnmodelled_px<S>, kSize2 = kUnmodelledSize<S> * kUnmodelledSize<S>;
  if (mark.kind != feature.kind) return {};
  const auto px = [](std::int32_t q16) { return static_cast<S>(q16) / S(65536); };
  const S du = px(mark.outer.u_q16) - feature.pixel.x(), dv = px(mark.outer.v_q16) - feature.pixel.y();
  const S R = static_cast<S>(mark.centre_variance_q24) / S(1 << 24) + kPixel2;
  const S uu = feature.covariance(0, 0) + R, uv = feature.covariance(1, 0), vv = feature.covariance(1, 1) + R;
  const S det = uu * vv - uv * uv;
  Innovation<S> found;
  found.centre = (vv * du * du - S(2) * uv * du * dv + uu * dv * dv) / det;
  if (!found.passes()) return found;

  const S m00 = px(mark.outer.m00_q16), m11 = px(mark.outer.m11_q16), area = m00 * m11;
  const S expected = px(feature.image.m00_q16) * px(feature.image.m11_q16);
  if (!(area > S(0) && expected > S(0))) return {};
  const S log_ratio = math::log(area / expected);
  const S axes = static_cast<S>(mark.axis_variance_q24) / S(1 << 24) * (m00 * m00 + m11 * m11) / (area * area);
  const S size_variance = feature.size_variance + axes + kSize2;
  found.size = log_ratio * log_ratio / size_variance;
  found.width = math::log(det * size_variance / (kPixel2 * kPixel2 * kSize2));
  return found;
}

}  // namespace articam::tracker
