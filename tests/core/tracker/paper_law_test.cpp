#include "core/tracker/paper_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/observe.hpp"

namespace articam {
namespace {

// The paper's equations once more, in its own 7 + n coordinates and with nothing of the core's algebra: numbers
// p (3), sigma (w x y z), q1, q2 of the printer as ANCHORS and PAPER_NOTES describe it, pseudo-inverse by SVD.
using Q9 = Eigen::Matrix<double, 9, 1>;
using Vec3 = Eigen::Vector3d;

Eigen::Matrix3d rotation(
    const Eigen::Vector4d& s) {  // homogeneous in sigma: its derivative keeps the radial part apart
  Eigen::Matrix3d R;
  const double w = s[0], x = s[1], y = s[2], z = s[3];
  R << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
      w * w - x * x + y * y - z * z, 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
      w * w - x * x - y * y + z * z;
  return R / s.squaredNorm();
}

Eigen::Matrix<double, 3, 6> points_in_object(double q1, double q2) {
  Eigen::Matrix<double, 3, 6> p;
  p << -0.16, 0.16, 0.16, -0.16, -0.06, -0.06 + q2, -0.10, -0.10, 0.02, 0.02, 0.10, 0.10, 0, 0, 0, 0, -q1, -q1;
  return p;
}

Eigen::Matrix<double, 12, 1> features(const Q9& q) {
  const auto p = points_in_object(q[7], q[8]);
  Eigen::Matrix<double, 12, 1> s;
  for (int i = 0; i < 6; ++i) {
    const Vec3 X = rotation(q.segment<4>(3)) * p.col(i) + q.head<3>();
    s.segment<2>(2 * i) = X.head<2>() / X.z();
  }
  return s;
}

/// A_i = -L_i J_i with J_i (6 x 9): rates of (p, sigma, q1, q2) -> twist at the origin of F_c.
Eigen::Matrix<double, 12, 9> articulation(const Q9& q) {
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

Q9 law(const Q9& q, const Eigen::Matrix<double, 12, 1>& s_star, const Eigen::Matrix<double, 12, 1>& s_star_dot,
       double lambda) {
  const Eigen::MatrixXd A = articulation(q);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Eigen::VectorXd inverse = svd.singularValues();
  for (double& value : inverse) value = value > 1e-10 * svd.singularValues()[0] ? 1 / value : 0;
  const Eigen::MatrixXd pinv = svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose();
  return -lambda * pinv * (features(q) - s_star) + pinv * s_star_dot;
}

Vec3 omega_of(const Q9& q, const Q9& qdot) {
  const double w = q[3], x = q[4], y = q[5], z = q[6];
  Eigen::Matrix<double, 3, 4> G;
  G << -x, w, -z, y, -y, z, w, -x, -z, -y, x, w;
  return 2 * G * qdot.segment<4>(3);
}

/// exp(Omega Ts) sigma with the 4 x 4 skew matrix, by its closed form.
Eigen::Vector4d turn(const Vec3& omega, double Ts, const Eigen::Vector4d& sigma) {
  Eigen::Matrix4d Omega;
  Omega << 0, -omega.x(), -omega.y(), -omega.z(), omega.x(), 0, -omega.z(), omega.y(), omega.y(), omega.z(), 0,
      -omega.x(), omega.z(), -omega.y(), omega.x(), 0;
  Omega *= 0.5;
  const double a = 0.5 * omega.norm() * Ts;
  if (a == 0) return sigma;
  return std::cos(a) * sigma + std::sin(a) / a * Ts * Omega * sigma;
}

Q9 numbers(const model::Configuration<models::PrinterDrawer, double>& q) {
  Q9 x;
  x << q.T_cam_obj.t, q.T_cam_obj.R.w(), q.T_cam_obj.R.x(), q.T_cam_obj.R.y(), q.T_cam_obj.R.z(), q.joints;
  return x;
}

using M = models::PrinterDrawer;
using tracker::FeatureKind;

TEST(PaperLaw, FollowsTheIndependentTranscriptionOfEquations5And6FromThePapersStart) {
  const auto truth = test::nominal_printer<M, double>();
  const auto matches = test::observe<M, double>(truth, FeatureKind::point);
  const Eigen::Matrix<double, 12, 1> s_star = features(numbers(truth));
  const tracker::GainProfile profile;
  constexpr double Ts = 1.0 / 30;

  auto q = model::from_numbers<M, double>(M::kQ0).value();
  tracker::PaperIntegrator<M, double> integrator;
  Q9 x = numbers(q), previous = Q9::Zero();
  Vec3 previous_omega = Vec3::Zero();
  for (int k = 0; k < 120; ++k) {
    tracker::System<M, double> system;
    ASSERT_EQ(stack(matches, q, FeatureKind::point, system), Status::ok);
    const double lambda = tracker::gain(profile, system.e.norm());
    const Vec<double, 12> no_feed_forward = Vec<double, 12>::Zero();
    q = integrator.integrate(q, tracker::control_law(system, lambda, no_feed_forward), Ts);

    const double norm = (features(x) - s_star).norm();
    const double paper_lambda = (5 - 2) * std::exp(-profile.slope * norm / (5 - 2)) + 2;
    ASSERT_NEAR(lambda, paper_lambda, 1e-12);
    const Q9 rates = law(x, s_star, no_feed_forward, paper_lambda);
    const Vec3 omega = omega_of(x, rates);
    x.head<3>() += (rates.head<3>() + previous.head<3>()) * (Ts / 2);
    x.segment<4>(3) = turn(previous_omega, Ts, x.segment<4>(3));
    x.tail<2>() += (rates.tail<2>() + previous.tail<2>()) * (Ts / 2);
    previous = rates;
    previous_omega = omega;
    ASSERT_LT((numbers(q) - x).cwiseAbs().maxCoeff(), 1e-12) << "frame " << k;
  }
  EXPECT_LT((numbers(q) - numbers(truth)).cwiseAbs().maxCoeff(), 1e-3);  // 4 s at lambda 5: it has arrived
}

TEST(PaperLaw, GivesTheSameMotionInTangentCoordinatesAsIn7PlusNRatesAlsoWithoutFullRank) {
  test::Random random{10};
  for (int missing = -1; missing < 6; ++missing) {  // without a drawer marker A loses rank
    const auto q = test::nominal_printer<M, double>();
    auto matches = test::observe<M, double>(model::integrate<M, double>(q, random.vector<double, 8>(-0.02, 0.02)),
                                            FeatureKind::point);
    if (missing >= 0) matches[static_cast<std::size_t>(missing)].matched = false;
    tracker::System<M, double> system;
    ASSERT_EQ(stack(matches, q, FeatureKind::point, system), Status::ok);
    const Vec<double, 12> s_star_dot = [&] {
      Vec<double, 12> rates = random.vector<double, 12>(-0.1, 0.1);
      if (missing >= 0) rates.segment<2>(2 * missing).setZero();
      return rates;
    }();
    const Vec<double, 8> ours = tracker::control_law(system, 3.0, s_star_dot);

    const Q9 x = numbers(q);
    Eigen::MatrixXd A = articulation(x);
    if (missing >= 0) A.middleRows<2>(2 * missing).setZero();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
    Eigen::VectorXd inverse = svd.singularValues();
    for (double& value : inverse) value = value > 1e-10 * svd.singularValues()[0] ? 1 / value : 0;
    const Q9 rates = svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose() * (s_star_dot - 3.0 * system.e);
    Vec<double, 8> paper;
    paper << rates.head<3>(), omega_of(x, rates), rates.tail<2>();
    // cond(A)^2 of about 4e4 times the rounding of the rates (up to 2 per second)
    EXPECT_LT((ours - paper).cwiseAbs().maxCoeff(), 1e-11) << "without marker " << missing;
  }
}

TEST(PaperLaw, FeedForwardCancelsTheErrorsGrowthUnderMotion) {
  // With e = 0 and s_star moving as A qdot, (5) returns that qdot.
  test::Random random{11};
  const auto q = test::nominal_printer<M, double>();
  tracker::System<M, double> system;
  ASSERT_EQ(stack(test::observe<M, double>(q, FeatureKind::point), q, FeatureKind::point, system), Status::ok);
  const Vec<double, 8> qdot = random.vector<double, 8>(-0.1, 0.1);
  const Vec<double, 12> s_star_dot = system.A * qdot;
  EXPECT_LT((tracker::control_law(system, 5.0, s_star_dot) - qdot).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PaperLaw, GainRunsFromItsMaximumAtZeroErrorToItsMinimumAndFallsAllTheWay) {
  const tracker::GainProfile profile;
  EXPECT_EQ(tracker::gain(profile, 0.0), 5.0);
  EXPECT_NEAR(tracker::gain(profile, 10.0), 2.0, 1e-12);
  for (double e = 0; e < 0.5; e += 0.01) EXPECT_GT(tracker::gain(profile, e), tracker::gain(profile, e + 0.01));
  EXPECT_NEAR((tracker::gain(profile, 0.0) - tracker::gain(profile, 1e-6)) / 1e-6, profile.slope, 1e-2);
}

}  // namespace
}  // namespace articam
