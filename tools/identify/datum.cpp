#include "tools/identify/datum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

#include "core/math/so3.hpp"
#include "tools/identify/arrow.hpp"

namespace articam::identify {
namespace {

/// Every way to displace the markers that may look like something else: a column each of
/// three shifts and three turns of all, a larger scale, another zero of each joint.
MatrixXd candidates(const Object& object, const Constants& constants, const Free& solution) {
  const auto markers =
      object.place(solution.values, solution.constants.segment(constants.places(), constants.num_places()));
  MatrixXd ways = MatrixXd::Zero(constants.size(), 7 + object.num_values());
  for (int m = 0; m < object.num_markers(); ++m) {
    if (!solution.seen[static_cast<std::size_t>(m)]) continue;
    const PlacedMarker& marker = markers[static_cast<std::size_t>(m)];
    const Mat3 R_body_obj = marker.R_obj_body.transpose();
    auto rows = ways.middleRows<3>(constants.places() + 3 * m);
    rows.leftCols<3>() = R_body_obj;
    rows.middleCols<3>(3) = -R_body_obj * math::hat<double>(marker.centre);
    rows.col(6) = R_body_obj * marker.centre;
    rows.rightCols(object.num_values()) = R_body_obj * marker.centre_by_value;
  }
  for (int i = 0; i < constants.num_still(); ++i) ways(i, 7 + constants.still()[static_cast<std::size_t>(i)]) = -1;
  return ways;
}

/// Of the candidates' combinations, those that leave every marker unknown by more than a millimetre.
MatrixXd untold(const MatrixXd& ways, const Constants& constants, const MatrixXd& information) {
  constexpr double kTold_m = 1e-3;
  const MatrixXd places = ways.middleRows(constants.places(), constants.num_places());
  const Eigen::JacobiSVD<MatrixXd> svd{places, Eigen::ComputeThinV};
  const auto& sizes = svd.singularValues();
  const Eigen::Index rank = (sizes.array() > 1e-6 * sizes[0]).count();
  const MatrixXd basis = ways * svd.matrixV().leftCols(rank) * sizes.head(rank).cwiseInverse().asDiagonal();
  const Eigen::Index num_object = constants.camera();
  const MatrixXd told =
      basis.topRows(num_object).transpose() * marginal(information, num_object) * basis.topRows(num_object);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen{told};
  const double least = 3.0 / (kTold_m * kTold_m * static_cast<double>(constants.num_places()));
  return basis * eigen.eigenvectors().leftCols((eigen.eigenvalues().array() < least).count());
}

VectorXd distances(const Constants& constants, const VectorXd& x) {
  const VectorXd places = x.segment(constants.places(), constants.num_places());
  return Eigen::Map<const Eigen::Matrix3Xd>(places.data(), 3, places.size() / 3).colwise().norm();
}

/// (H^T W H)^-1 H^T W over the places, a weight for each marker: what a displacement looks like along the held ways.
MatrixXd seen_along(const MatrixXd& held, const Constants& constants, const VectorXd& weights) {
  MatrixXd weighted = MatrixXd::Zero(held.rows(), held.cols());
  for (Eigen::Index m = 0; m < weights.size(); ++m)
    weighted.middleRows<3>(constants.places() + 3 * m) = weights[m] * held.middleRows<3>(constants.places() + 3 * m);
  return (weighted.transpose() * held).ldlt().solve(weighted.transpose());
}

/// The displacement along the held ways after which the sum of the markers' distances is least.
VectorXd least_distances(const MatrixXd& held, const Constants& constants, const VectorXd& x) {
  constexpr double kSmooth_m = 1e-6;
  constexpr int kRounds = 200;
  VectorXd shift = VectorXd::Zero(x.size());
  for (int i = 0; i < kRounds; ++i) {
    const VectorXd weights = (distances(constants, x + shift).array().square() + kSmooth_m * kSmooth_m).rsqrt();
    shift -= held * (seen_along(held, constants, weights) * (x + shift));
  }
  return shift;
}

MatrixXd covariance_held(const MatrixXd& covariance, const MatrixXd& held, const Constants& constants,
                         const VectorXd& weights) {
  const MatrixXd hold =
      MatrixXd::Identity(covariance.rows(), covariance.cols()) - held * seen_along(held, constants, weights);
  return hold * covariance * hold.transpose();
}

}  // namespace

Datum hold_datum(const Object& object, const Constants& constants, const Free& solution) {
  constexpr double kDisplaced = 4, kHardly = 1e-6;  // deviations; a displaced marker's part in holding the frame
  constexpr int kRounds = 5;
  const VectorXd& x = solution.constants;
  const MatrixXd free = solution.information.ldlt().solve(MatrixXd::Identity(x.size(), x.size()));
  Datum datum{MatrixXd::Zero(x.size(), 0), solution.seen, free, VectorXd::Zero(x.size())};
  if (constants.num_places() == 0) return datum;
  datum.held = untold(candidates(object, constants, solution), constants, solution.information);
  if (datum.held.cols() == 0) return datum;

  // From the least sum on: whatever marker fits those that hold the frame holds it with them.
  VectorXd weights = VectorXd::Ones(object.num_markers());
  datum.shift = least_distances(datum.held, constants, x);
  for (int i = 0; i < kRounds; ++i) {
    datum.covariance = covariance_held(free, datum.held, constants, weights);
    const VectorXd far = distances(constants, x + datum.shift);
    for (int m = 0; m < object.num_markers(); ++m) {
      const int row = constants.places() + 3 * m;
      const bool fits = far[m] * far[m] < kDisplaced * kDisplaced * datum.covariance.block<3, 3>(row, row).trace();
      datum.reference[static_cast<std::size_t>(m)] = fits && solution.seen[static_cast<std::size_t>(m)];
      weights[m] = fits ? 1 : kHardly;
    }
    datum.shift = -datum.held * (seen_along(datum.held, constants, weights) * x);
  }
  datum.covariance = covariance_held(free, datum.held, constants, weights);
  return datum;
}

}  // namespace articam::identify
