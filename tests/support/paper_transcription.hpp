#pragma once
/// @file  The paper's equations once more, in its own 7 + n coordinates and with nothing of the core's algebra.
///
/// For the printer of ANCHORS and PAPER_NOTES: q = p (3), sigma (w x y z), q1, q2; pseudo-inverse by Eigen's SVD.

#include <Eigen/Dense>
#include <cmath>

#include "core/model/configuration.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"

namespace articam::test::paper {

using Q9 = Eigen::Matrix<double, 9, 1>;
using Vec3 = Eigen::Vector3d;

inline Eigen::Matrix3d rotation(
    const Eigen::Vector4d& s) {  // homogeneous in sigma: its derivative keeps the radial part apart
  Eigen::Matrix3d R;
  const double w = s[0], x = s[1], y = s[2], z = s[3];
  R << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
      w * w - x * x + y * y - z * z, 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
      w * w - x * x - y * y + z * z;
  return R / s.squaredNorm();
}

inline Eigen::Matrix<double, 3, 6> points_in_object(double q1, double q2) {
  Eigen::Matrix<double, 3, 6> p;
  p << -0.16, 0.16, 0.16, -0.16, -0.06, -0.06 + q2, -0.10, -0.10, 0.02, 0.02, 0.10, 0.10, 0, 0, 0, 0, -q1, -q1;
  return p;
}

inline Eigen::Matrix<double, 12, 1> features(const Q9& q) {
  const auto p = points_in_object(q[7], q[8]);
  Eigen::Matrix<double, 12, 1> s;
  for (int i = 0; i < 6; ++i) {
    const Vec3 X = rotation(q.segment<4>(3)) * p.col(i) + q.head<3>();
    s.segment<2>(2 * i) = X.head<2>() / X.z();
  }
  return s;
}

/// A_i = -L_i J_i with J_i (6 x 9): rates of (p, sigma, q1, q2) -> twist at the origin of F_c.
inline Eigen::Matrix<double, 12, 9> articulation(const Q9& q) {
  const auto p = points_in_object(q[7], q[8]);
  const Eigen::Matrix3d R = rotation(q.segment<4>(3));
  const double w = q[3], x = q[4], y = q[5], z = q[6];
  Eigen::Matrix<double, 3, 4> omega_of_sigma_dot;  // 2 sigma_dot sigma^-1, vector part
  omega_of_sigma_dot << -x, w, -z, y, -y, z, w, -x, -z, -y, x, w;
  omega_of_sigma_dot *= 2;
  Eigen::Matrix<double, 12, 9> A;
  for (int i = 0; i < 6; ++i) {
    const Vec3 X = R * p.col(i) + q.head<3>();
    const double u = X.x() / X.z(), v = X.y() / X.z(), Z = X.z();
    Eigen::Matrix<double, 2, 6> L;
    L << -1 / Z, 0, u / Z, u * v, -(1 + u * u), v, 0, -1 / Z, v / Z, 1 + v * v, -u * v, -u;
    Eigen::Matrix<double, 6, 9> J = Eigen::Matrix<double, 6, 9>::Zero();
    J.block<3, 3>(0, 0).setIdentity();
    for (int c = 0; c < 4; ++c) {
      const Vec3 omega = omega_of_sigma_dot.col(c);
      J.block<3, 1>(0, 3 + c) = q.head<3>().cross(omega);
      J.block<3, 1>(3, 3 + c) = omega;
    }
    if (i >= 4) J.block<3, 1>(0, 7) = R * Vec3{0, 0, -1};
    if (i == 5) J.block<3, 1>(0, 8) = R * Vec3{1, 0, 0};
    A.middleRows<2>(2 * i) = -L * J;
  }
  return A;
}

inline Q9 law(const Q9& q, const Eigen::Matrix<double, 12, 1>& s_star, const Eigen::Matrix<double, 12, 1>& s_star_dot,
              double lambda) {
  const Eigen::MatrixXd A = articulation(q);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Eigen::VectorXd inverse = svd.singularValues();
  for (double& value : inverse) value = value > 1e-10 * svd.singularValues()[0] ? 1 / value : 0;
  const Eigen::MatrixXd pinv = svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose();
  return -lambda * pinv * (features(q) - s_star) + pinv * s_star_dot;
}

inline Vec3 omega_of(const Q9& q, const Q9& qdot) {
  const double w = q[3], x = q[4], y = q[5], z = q[6];
  Eigen::Matrix<double, 3, 4> G;
  G << -x, w, -z, y, -y, z, w, -x, -z, -y, x, w;
  return 2 * G * qdot.segment<4>(3);
}

/// exp(Omega Ts) sigma with the 4 x 4 skew matrix, by its closed form.
inline Eigen::Vector4d turn(const Vec3& omega, double Ts, const Eigen::Vector4d& sigma) {
  Eigen::Matrix4d Omega;
  Omega << 0, -omega.x(), -omega.y(), -omega.z(), omega.x(), 0, -omega.z(), omega.y(), omega.y(), omega.z(), 0,
      -omega.x(), omega.z(), -omega.y(), omega.x(), 0;
  Omega *= 0.5;
  const double a = 0.5 * omega.norm() * Ts;
  if (a == 0) return sigma;
  return std::cos(a) * sigma + std::sin(a) / a * Ts * Omega * sigma;
}

inline Q9 numbers(const model::Configuration<models::PrinterDrawer, double>& q) {
  Q9 x;
  x << q.T_cam_obj.t, q.T_cam_obj.R.w(), q.T_cam_obj.R.x(), q.T_cam_obj.R.y(), q.T_cam_obj.R.z(), q.joints;
  return x;
}

/// One frame: (5) without feed-forward, the gain profile with its default numbers and slope, and (6).
class Paper {
 public:
  explicit Paper(const Q9& q0) : x_{q0} {}

  void step(const Eigen::Matrix<double, 12, 1>& s_star, double slope, double Ts) {
    const double norm = (features(x_) - s_star).norm();
    lambda_ = (5 - 2) * std::exp(-slope * norm / (5 - 2)) + 2;
    const Q9 rates = law(x_, s_star, Eigen::Matrix<double, 12, 1>::Zero(), lambda_);
    const Vec3 omega = omega_of(x_, rates);
    x_.head<3>() += (rates.head<3>() + previous_.head<3>()) * (Ts / 2);
    x_.segment<4>(3) = turn(previous_omega_, Ts, x_.segment<4>(3));
    x_.tail<2>() += (rates.tail<2>() + previous_.tail<2>()) * (Ts / 2);
    previous_ = rates;
    previous_omega_ = omega;
  }
  const Q9& q() const { return x_; }
  double lambda() const { return lambda_; }

 private:
  Q9 x_, previous_ = Q9::Zero();
  Vec3 previous_omega_ = Vec3::Zero();
  double lambda_{};
};

}  // namespace articam::test::paper
