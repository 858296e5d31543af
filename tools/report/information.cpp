#include "tools/report/information.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>

namespace articam::report {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kMinDepth_m = 0.01;
constexpr double kNoEigenvalue = 1e-10;  ///< of a matrix with ones on its diagonal: roundings stay below
constexpr double kNoMotion = 1e-12;      ///< squared px over squared px across: what rounding leaves of none
constexpr double kPartOf = 1e-6;         ///< squared component in a direction that nothing is known of

/// The centre's velocity per step: t, rotation about the axes of {cam}, joints.
Eigen::Matrix<double, 3, Eigen::Dynamic> velocity_in_camera(const Marks& marks, std::size_t m, const View& view) {
  Eigen::Matrix<double, 3, Eigen::Dynamic> v(3, 6 + view.joints.size());
  const Vec3 arm = view.T_cam_obj.R * marks.centre[m];
  v.leftCols<3>().setIdentity();
  for (int i = 0; i < 3; ++i) v.col(3 + i) = Vec3::Unit(i).cross(arm);
  v.rightCols(view.joints.size()) = view.T_cam_obj.R.toRotationMatrix() * marks.velocity[m];
  return v;
}

bool inside(const Vec3& p, double radius_px, const CameraParameters& camera) {
  const double u = camera.fx_px * p.x() / p.z() + camera.cx_px, v = camera.fy_px * p.y() / p.z() + camera.cy_px;
  return u > radius_px && u < camera.width_px - 1 - radius_px && v > radius_px && v < camera.height_px - 1 - radius_px;
}

/// Steps of comparable size for the singular values: 1 cm, 1 deg.
VectorX natural_steps(const modelgen::Table& table) {
  VectorX steps(6 + static_cast<Eigen::Index>(table.values().size()));
  for (Eigen::Index i = 0; i < steps.size(); ++i) {
    steps[i] = is_metres(table, static_cast<std::size_t>(i)) ? 0.01 : kDegree;
  }
  return steps;
}

}  // namespace

bool is_metres(const modelgen::Table& table, std::size_t i) {
  return i < 3 || (i >= 6 && table.values()[i - 6]->kind == model::JointKind::prismatic);
}

std::vector<Sight> look(const modelgen::Table& table, const View& view, const CameraParameters& camera) {
  const Marks marks = place_marks(table, view.joints);
  std::vector<Sight> sights(table.markers.size());
  for (std::size_t m = 0; m < sights.size(); ++m) {
    const Vec3 p = view.T_cam_obj * marks.centre[m];
    Sight& sight = sights[m];
    sight.A.setZero(2, 6 + view.joints.size());
    sight.across_px.setZero(6 + view.joints.size());
    if (!(p.z() > kMinDepth_m)) continue;
    Eigen::Matrix<double, 2, 3> L;
    L << camera.fx_px / p.z(), 0, -camera.fx_px * p.x() / (p.z() * p.z()), 0, camera.fy_px / p.z(),
        -camera.fy_px * p.y() / (p.z() * p.z());
    const auto velocity = velocity_in_camera(marks, m, view);
    sight.A = L * velocity;
    sight.across_px = camera.fx_px / p.z() * velocity.colwise().norm().transpose();
    sight.diameter_px = camera.fx_px * table.markers[m].outer_diameter_m / p.z();
    const double facing = -(view.T_cam_obj.R * marks.normal[m]).dot(p.normalized());
    if (sight.diameter_px < kMinDiameter_px) {
      sight.sighting = Sighting::too_small;
    } else if (!(facing > std::cos(kMaxTilt_deg * kDegree))) {
      sight.sighting = Sighting::turned_away;
    } else if (inside(p, 0.5 * sight.diameter_px, camera)) {
      sight.sighting = Sighting::seen;
    }
  }
  return sights;
}

MatrixX information(const std::vector<Sight>& sights, const std::vector<bool>& use) {
  const Eigen::Index n = sights.empty() ? 6 : sights.front().A.cols();
  MatrixX sum = MatrixX::Zero(n, n);
  for (std::size_t m = 0; m < sights.size(); ++m) {
    if (use[m] && sights[m].seen()) sum += sights[m].A.transpose() * sights[m].A;
  }
  return sum;
}

double least_singular_px(const std::vector<Sight>& sights, const std::vector<bool>& use, const modelgen::Table& table) {
  const VectorX steps = natural_steps(table);
  const MatrixX stepped = steps.asDiagonal() * information(sights, use) * steps.asDiagonal();
  const double least = Eigen::SelfAdjointEigenSolver<MatrixX>(stepped, Eigen::EigenvaluesOnly).eigenvalues()[0];
  return std::sqrt(std::max(0.0, least));
}

VectorX known_beforehand(const modelgen::Table& table) {
  const auto values = table.values();
  VectorX known(6 + static_cast<Eigen::Index>(values.size()));
  known << 10, 10, 10, std::numbers::pi, std::numbers::pi, std::numbers::pi, VectorX::Zero(known.size() - 6);
  for (std::size_t j = 0; j < values.size(); ++j) {
    const double range = std::max(high_limit(*values[j]) - low_limit(*values[j]), 1e-6);
    known[static_cast<Eigen::Index>(6 + j)] = range / std::sqrt(12.0);
  }
  return known;
}

Bound bound(const std::vector<Sight>& sights, const std::vector<bool>& use, const VectorX& beforehand,
            double noise_px) {
  const MatrixX I = information(sights, use);
  const Eigen::Index n = I.rows();
  VectorX across = VectorX::Zero(n);
  for (std::size_t m = 0; m < sights.size(); ++m) {
    if (use[m] && sights[m].seen()) across += sights[m].across_px.cwiseAbs2();
  }
  VectorX scale = VectorX::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (I(i, i) > kNoMotion * across[i]) scale[i] = 1 / std::sqrt(I(i, i));
  }
  const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(scale.asDiagonal() * I * scale.asDiagonal());
  const VectorX& lambda = eigen.eigenvalues();
  const MatrixX& U = eigen.eigenvectors();
  const VectorX unknown = U.cwiseAbs2() * (lambda.array() < kNoEigenvalue).cast<double>().matrix();
  const VectorX inverse = lambda.unaryExpr([](double x) { return x < kNoEigenvalue ? 0.0 : 1 / x; });

  Bound result;
  result.covariance =
      noise_px * noise_px * (scale.asDiagonal() * U * inverse.asDiagonal() * U.transpose() * scale.asDiagonal());
  result.deviation = result.dilution = VectorX::Constant(n, std::numeric_limits<double>::infinity());
  for (Eigen::Index i = 0; i < n; ++i) {
    const double deviation = std::sqrt(result.covariance(i, i));
    const bool observed = scale[i] > 0 && unknown[i] < kPartOf && deviation < beforehand[i];
    result.observed.push_back(observed);
    if (!observed) {
      result.covariance.row(i).setZero();
      result.covariance.col(i).setZero();
      continue;
    }
    result.deviation[i] = deviation;
    result.dilution[i] = result.deviation[i] * std::sqrt(across[i]) / noise_px;
  }
  return result;
}

Bound bound(const std::vector<Sight>& sights, const VectorX& beforehand, double noise_px) {
  return bound(sights, std::vector<bool>(sights.size(), true), beforehand, noise_px);
}

}  // namespace articam::report
