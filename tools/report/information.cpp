#include "tools/report/information.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>

namespace articam::report {
namespace {

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

/// Of the inverse of a symmetric matrix with ones on its diagonal.
struct Variances {
  VectorX known;    ///< its diagonal, without the directions that nothing is known of
  VectorX unknown;  ///< of every number, its squared component in these
};

Variances invert(const MatrixX& scaled) {
  const Eigen::Index n = scaled.rows();
  const Eigen::LLT<MatrixX> llt(scaled);
  if (llt.info() == Eigen::Success) {
    const VectorX variances = llt.matrixL().solve(MatrixX::Identity(n, n)).colwise().squaredNorm();
    // No eigenvalue is below one over their sum: most often nothing more need be asked.
    if (variances.sum() < 1 / kNoEigenvalue) return {variances, VectorX::Zero(n)};
  }
  const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(scaled);
  const VectorX& lambda = eigen.eigenvalues();
  const MatrixX parts = eigen.eigenvectors().cwiseAbs2();
  return {parts * lambda.unaryExpr([](double x) { return x < kNoEigenvalue ? 0.0 : 1 / x; }),
          parts * (lambda.array() < kNoEigenvalue).cast<double>().matrix()};
}

/// Whether entry i of a step moves a mark that is seen.
bool moves(const Information& information, Eigen::Index i) {
  return information.sum_px2(i, i) > kNoMotion * information.across_px2[i];
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

Information information(const std::vector<Sight>& sights, const std::vector<bool>& use) {
  const Eigen::Index n = sights.empty() ? 6 : sights.front().A.cols();
  Information known{MatrixX::Zero(n, n), VectorX::Zero(n)};
  for (std::size_t m = 0; m < sights.size(); ++m) {
    if (!use[m] || !sights[m].seen()) continue;
    known.sum_px2.selfadjointView<Eigen::Lower>().rankUpdate(sights[m].A.transpose());
    known.across_px2 += sights[m].across_px.cwiseAbs2();
  }
  known.sum_px2.triangularView<Eigen::StrictlyUpper>() = known.sum_px2.transpose();
  return known;
}

Information information(const std::vector<Sight>& sights) {
  return information(sights, std::vector<bool>(sights.size(), true));
}

double least_singular_px(const Information& information, const modelgen::Table& table) {
  const VectorX steps = natural_steps(table);
  for (Eigen::Index i = 0; i < steps.size(); ++i) {
    if (!moves(information, i)) return 0;
  }
  const MatrixX stepped = steps.asDiagonal() * information.sum_px2 * steps.asDiagonal();
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

Bound bound(const Information& information, const VectorX& beforehand, double noise_px) {
  const MatrixX& I = information.sum_px2;
  const Eigen::Index n = I.rows();
  const VectorX unknown = VectorX::Constant(n, std::numeric_limits<double>::infinity());
  Bound result{std::vector<bool>(static_cast<std::size_t>(n)), unknown, unknown};
  std::vector<Eigen::Index> moving;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (moves(information, i)) moving.push_back(i);
  }
  if (moving.empty()) return result;
  const VectorX scale = I.diagonal()(moving).cwiseSqrt().cwiseInverse();
  const Variances variances = invert(scale.asDiagonal() * I(moving, moving) * scale.asDiagonal());
  for (Eigen::Index k = 0; k < scale.size(); ++k) {
    const Eigen::Index i = moving[static_cast<std::size_t>(k)];
    const double deviation = noise_px * scale[k] * std::sqrt(variances.known[k]);
    if (!(variances.unknown[k] < kPartOf && deviation < beforehand[i])) continue;
    result.observed[static_cast<std::size_t>(i)] = true;
    result.deviation[i] = deviation;
    result.dilution[i] = deviation * std::sqrt(information.across_px2[i]) / noise_px;
  }
  return result;
}

}  // namespace articam::report
