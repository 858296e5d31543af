#include "host_sim/report/roll_pitch_yaw.hpp"

#include <Eigen/LU>

#include <cmath>
#include <limits>

#include "core/math/trigonometry.hpp"

namespace articam::sim {

Vec<double, 3> roll_pitch_yaw(const Quat<double>& q) noexcept {
  const double sin_pitch = 2 * (q.w() * q.y() - q.z() * q.x());
  const double cos_pitch2 = 1 - sin_pitch * sin_pitch;
  return {math::atan2(2 * (q.w() * q.x() + q.y() * q.z()), 1 - 2 * (q.x() * q.x() + q.y() * q.y())),
          math::atan2(sin_pitch, std::sqrt(cos_pitch2 > 0 ? cos_pitch2 : 0.0)),
          math::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()))};
}

Vec<double, 3> roll_pitch_yaw_std(const Quat<double>& R, const Mat<double, 3, 3>& P) noexcept {
  const Vec<double, 3> angles = roll_pitch_yaw(R);
  const auto pitch = math::sin_cos(angles.y()), yaw = math::sin_cos(angles.z());
  // delta = E (roll, pitch, yaw)': each angle turns about its axis, as the later ones have left it.
  Mat<double, 3, 3> E;
  E << yaw.cos * pitch.cos, -yaw.sin, 0,  //
      yaw.sin * pitch.cos, yaw.cos, 0,    //
      -pitch.sin, 0, 1;
  if (!(std::abs(pitch.cos) > 1e-6)) return Vec<double, 3>::Constant(std::numeric_limits<double>::quiet_NaN());
  const Mat<double, 3, 3> J = E.inverse();
  return (J * P * J.transpose()).diagonal().cwiseMax(0.0).cwiseSqrt();
}

}  // namespace articam::sim
