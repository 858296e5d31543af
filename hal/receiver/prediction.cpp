#include "hal/receiver/prediction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/trigonometry.hpp"

namespace articam::receiver {
namespace {

using Vector = std::array<double, 3>;

struct Quaternion {
  double w{1};
  Vector v{};
};

struct Rigid {
  Vector t{};
  Quaternion R{};
};

Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) noexcept { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector operator+(const Vector& a, const Vector& b) noexcept { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator*(double s, const Vector& a) noexcept { return {s * a[0], s * a[1], s * a[2]}; }

Quaternion operator*(const Quaternion& a, const Quaternion& b) noexcept {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
Quaternion conjugate(const Quaternion& q) noexcept { return {q.w, -1.0 * q.v}; }
Quaternion normalized(const Quaternion& q) noexcept {
  const double scale = 1 / std::sqrt(q.w * q.w + dot(q.v, q.v));
  return {scale * q.w, scale * q.v};
}
Vector rotated(const Quaternion& q, const Vector& p) noexcept {
  const Vector twice = 2.0 * cross(q.v, p);
  return p + q.w * twice + cross(q.v, twice);
}

/// Rotation vector (rad) -> unit quaternion.
Quaternion exponential(const Vector& phi) noexcept {
  const double angle = std::sqrt(dot(phi, phi));
  if (angle < 1e-8) return normalized({1, 0.5 * phi});  // the next term, angle^2 / 24, is below the last bit
  const auto half = math::sin_cos(0.5 * angle);
  return {half.cos, (half.sin / angle) * phi};
}

Rigid rigid(const wire::PoseNumbers& x) noexcept { return {{x[0], x[1], x[2]}, {x[3], {x[4], x[5], x[6]}}}; }

bool write(const Rigid& T, wire::PoseNumbers& out) noexcept {
  const auto& [t, R] = T;
  std::ranges::copy(std::array{t[0], t[1], t[2], R.w, R.v[0], R.v[1], R.v[2]}, out.begin());
  return std::ranges::all_of(out, [](double x) { return x - x == 0; });
}

}  // namespace

bool predict(wire::EstimateMessage& estimate, double dt_s) noexcept {
  if (!estimate.valid) return true;
  auto joints = estimate.joints;
  auto t_cam_obj = estimate.t_cam_obj, t_base_obj = estimate.t_base_obj;
  const auto& rate = estimate.velocity;
  const Rigid before = rigid(t_cam_obj);
  const Vector v{rate[0], rate[1], rate[2]}, w{rate[3], rate[4], rate[5]};
  const Rigid after{before.t + dt_s * v, normalized(exponential(dt_s * w) * before.R)};
  bool finite = write(after, t_cam_obj);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints[j] += dt_s * rate[6 + j];
    finite = finite && joints[j] - joints[j] == 0;
  }
  if (!t_base_obj.empty()) {
    // T_base_cam stands still, and both poses at the capture tell it.
    const Rigid old = rigid(t_base_obj);
    const Quaternion R_base_cam = normalized(old.R * conjugate(before.R));
    const Vector t_base_cam = old.t + -1.0 * rotated(R_base_cam, before.t);
    finite = finite && write({rotated(R_base_cam, after.t) + t_base_cam, normalized(R_base_cam * after.R)}, t_base_obj);
  }
  if (!finite) return false;
  estimate.joints = joints, estimate.t_cam_obj = t_cam_obj, estimate.t_base_obj = t_base_obj;
  return true;
}

}  // namespace articam::receiver
