#pragma once
/// @file  Two marks taken for two markers -> the pose that this means, if any.

#include "core/model/forward_kinematics.hpp"
#include "core/tracker/sighting.hpp"

namespace articam::tracker {

/// A marker of the model: its place in {obj} and its radius.
template <class S>
struct PlacedMarker {
  model::MarkerPlace<S> place;
  S radius_m;
};

/// The normal of a mark seen almost from the front is known to a quarter of a radian only: an edge that is 3 % short of
/// a circle looks tilted by that much. This bounds the difference of cosines.
template <class S>
inline constexpr S kMaxCosineError = S(0.45);

/// How much the measured distance of two marks may differ from their distance on the object: the errors of both ranges,
/// along the line between the marks and, to second order, across it.
template <class S>
S distance_tolerance(const Vec<S, 3>& p, const Vec<S, 3>& q, S error_p, S error_q) noexcept {
  const Vec<S, 3> line = q - p;
  const S length = line.norm(), range_p = p.norm(), range_q = q.norm();
  const S along_p = line.dot(p) / (length * range_p), along_q = line.dot(q) / (length * range_q);
  const S depth_p = error_p * range_p, depth_q = error_q * range_q;
  const S across = depth_p + depth_q;
  return std::sqrt(along_p * along_p * depth_p * depth_p + along_q * along_q * depth_q * depth_q) +
         S(0.25) * across * across / length + S(0.5) * (error_p + error_q) * length;
}

/// The rotation that turns the directions (x, n) of {obj} into those of {cam}, x exactly.
/// Errors  ill_conditioned where n is nearly along x.
template <class S>
Result<Quat<S>> turn_onto(const Vec<S, 3>& x_cam, const Vec<S, 3>& n_cam, const Vec<S, 3>& x_obj,
                          const Vec<S, 3>& n_obj) noexcept {
  const auto basis = [](const Vec<S, 3>& x, const Vec<S, 3>& n) -> Mat<S, 3, 3> {
    const Vec<S, 3> across = x.cross(n);
    Mat<S, 3, 3> b;
    b.col(0) = x;
    b.col(1) = across / across.norm();
    b.col(2) = x.cross(Vec<S, 3>(b.col(1)));
    return b;
  };
  constexpr S kMinSine2 = S(0.1);
  if (!(x_cam.cross(n_cam).squaredNorm() > kMinSine2 * n_cam.squaredNorm())) return Status::ill_conditioned;
  if (!(x_obj.cross(n_obj).squaredNorm() > kMinSine2 * n_obj.squaredNorm())) return Status::ill_conditioned;
  const Mat<S, 3, 3> R = basis(x_cam, n_cam).lazyProduct(basis(x_obj, n_obj).transpose());
  return Quat<S>(R).normalized();
}

/// T_cam_obj that puts marker a where sighting i is, with the normal of its pose `side`, and marker b where sighting j
/// is, on the side that suits better. Distance and normals must agree with the model's within their errors.
/// Errors  bad_argument where they do not; ill_conditioned where the normals lie along the line of the two.
template <class S>
Result<Pose<S>> pair_pose(const PlacedMarker<S>& a, const PlacedMarker<S>& b, const Sighting<S>& i, std::size_t side,
                          const Sighting<S>& j) noexcept {
  const Vec<S, 3> p_i = a.radius_m * i.unit_circle[side].centre, n_i = i.unit_circle[side].normal;
  const Vec<S, 3> line = b.place.centre - a.place.centre;
  const Vec<S, 3> seen_line = b.radius_m * j.unit_circle[0].centre - p_i;
  const S length = line.norm(), seen_length = seen_line.norm();
  if (!(length > S(0)) || !(seen_length > S(0))) return Status::ill_conditioned;
  const S slack = distance_tolerance<S>(p_i, p_i + seen_line, i.range_error, j.range_error);
  if (!(std::abs(seen_length - length) <= slack)) return Status::bad_argument;

  const Vec<S, 3> x_obj = line / length, x_cam = seen_line / seen_length;
  const S between = a.place.normal.dot(b.place.normal), along = b.place.normal.dot(x_obj);
  const auto error = [&](std::size_t k) {
    const Vec<S, 3>& n_j = j.unit_circle[k].normal;
    const S of_normals = std::abs(n_i.dot(n_j) - between), of_line = std::abs(n_j.dot(x_cam) - along);
    return of_normals > of_line ? of_normals : of_line;
  };
  const std::size_t best = error(1) < error(0) ? 1 : 0;
  if (!(error(best) <= kMaxCosineError<S>)) return Status::bad_argument;
  if (!(std::abs(n_i.dot(x_cam) - a.place.normal.dot(x_obj)) <= kMaxCosineError<S>)) return Status::bad_argument;

  const bool opposed = between < S(-0.5);  // their sum says nothing then
  const Vec<S, 3> n_obj = opposed ? a.place.normal : Vec<S, 3>(a.place.normal + b.place.normal);
  const Vec<S, 3> n_cam = opposed ? n_i : Vec<S, 3>(n_i + j.unit_circle[best].normal);
  const auto R = turn_onto<S>(x_cam, n_cam, x_obj, n_obj);
  if (!R.ok()) return R.status();
  Pose<S> T_cam_obj{R.value(), Vec<S, 3>::Zero()};
  T_cam_obj.t = p_i + S(0.5) * seen_line - T_cam_obj.R * Vec<S, 3>(S(0.5) * (a.place.centre + b.place.centre));
  return T_cam_obj;
}

}  // namespace articam::tracker
