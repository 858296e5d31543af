#pragma once
/// @file  Joint values -> where every body is and how every joint moves it, unrolled over the table.
///
/// All is seen from {obj}'s origin and written along axes that the caller chooses: {obj}'s own, or the camera's. In a
/// model's table most numbers are 0 or 1; what they multiply is not computed.

#include <utility>

#include "core/math/trigonometry.hpp"
#include "core/math/triple.hpp"
#include "core/model/model_table.hpp"

namespace articam::model {

/// How a unit rate of a joint moves the bodies behind it: a point at p by linear + angular x p.
template <class S>
struct JointMotion {
  math::Triple<S> linear;   ///< m/s per unit rate, of the point of the body that passes the origin
  math::Triple<S> angular;  ///< rad/s per unit rate; of a slide it is not set
};

template <class S>
struct BodyPlace {
  math::Axes<S> axes;
  math::Triple<S> origin;  ///< m
  JointMotion<S> motion;   ///< of the joint above the body
};

template <class M, class S>
using BodyPlaces = std::array<BodyPlace<S>, static_cast<std::size_t>(kNumBodies<M> + 1)>;  ///< [body + 1], 0 the root

/// A constant point of a body, seen like the body. The root begins at the origin.
template <class S>
[[gnu::always_inline]] constexpr math::Triple<S> place_point(const BodyPlace<S>& body, bool is_root,
                                                             const std::array<double, 3>& p) noexcept {
  return is_root ? along(body.axes, p) : along(body.origin, body.axes, p);
}

/// A rotation of the table. Its numbers are rounded at 15 decimals: what is nearer to 0 or +-1 than that, is that.
constexpr math::Axes<double> constant_axes(const std::array<double, 4>& wxyz) noexcept {
  math::Axes<double> R = math::axes_of(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  for (math::Triple<double>* axis : {&R.x, &R.y, &R.z}) {
    for (double* c : {&axis->x, &axis->y, &axis->z}) {
      for (const double exact : {-1.0, 0.0, 1.0}) {
        if (*c > exact - 2e-15 && *c < exact + 2e-15) *c = exact;
      }
    }
  }
  return R;
}

namespace detail {

/// Where the joint of a row stands.
template <class M, class S>
S joint_position(std::size_t row, const Vec<S, kNumJoints<M>>& joints) noexcept {
  const S value = joints[static_cast<Eigen::Index>(kValueOfRow<M>[row])];
  const JointRow& joint = M::kJoints[row];
  return joint.leader < 0 ? value : static_cast<S>(joint.ratio) * value + static_cast<S>(joint.offset);
}

/// Of its own, as every turning joint would bring another copy of it into the straight code.
template <class S>
[[gnu::noinline]] math::SinCos<S> turn_by(S angle_rad) noexcept {
  return math::sin_cos(angle_rad);
}

/// Written member by member: a struct copied as a whole goes through memory, and is waited for.
template <class M, class S, std::size_t kRow>
[[gnu::always_inline]] inline void place_body(const BodyPlace<S>& parent, const Vec<S, kNumJoints<M>>& joints,
                                              BodyPlace<S>& place) noexcept {
  constexpr const JointRow& row = M::kJoints[kRow];
  constexpr math::Axes<double> R = constant_axes(row.r_parent_joint_wxyz);
  constexpr std::array<double, 3> x{R.x.x, R.x.y, R.x.z}, y{R.y.x, R.y.y, R.y.z}, z{R.z.x, R.z.y, R.z.z};
  const S position = joint_position<M, S>(kRow, joints);
  const math::Axes<S> axes{along(parent.axes, x), along(parent.axes, y), along(parent.axes, z)};
  const math::Triple<S> axis = along(axes, row.axis);
  const math::Triple<S> origin = place_point(parent, row.parent < 0, row.t_parent_joint_m);
  if constexpr (row.kind == JointKind::prismatic) {
    place.axes = axes;
    const bool starts_at_origin = row.parent < 0 && row.t_parent_joint_m == std::array<double, 3>{};
    place.origin = starts_at_origin ? position * axis : origin + position * axis;
    place.motion.linear = axis;
  } else {
    const auto turn = turn_by(position);
    place.axes = turned(axes, row.axis, turn.sin, turn.cos);
    place.origin = origin;
    place.motion.linear = cross(origin, axis);
    place.motion.angular = axis;
  }
}

template <class M, class S, std::size_t... kRow>
[[gnu::always_inline]] inline void place_bodies(BodyPlaces<M, S>& places, const Vec<S, kNumJoints<M>>& joints,
                                                std::index_sequence<kRow...>) noexcept {
  (place_body<M, S, kRow>(places[static_cast<std::size_t>(M::kJoints[kRow].parent + 1)], joints, places[kRow + 1]),
   ...);
}

}  // namespace detail

/// Joint values (rad or m, in the order of kValueRows) -> every body seen from {obj}'s origin, along the axes in which
/// {obj}'s are given. Cannot fail; values beyond the limits are taken as they are.
template <class M, class S>
[[gnu::always_inline]] inline void place_bodies(const math::Axes<S>& obj, const Vec<S, kNumJoints<M>>& joints,
                                                BodyPlaces<M, S>& places) noexcept {
  places[0].axes = obj;
  places[0].origin = {};
  detail::place_bodies<M, S>(places, joints, std::make_index_sequence<M::kJoints.size()>{});
}

}  // namespace articam::model
