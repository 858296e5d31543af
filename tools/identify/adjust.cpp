#include "tools/identify/adjust.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/so3.hpp"
#include "tools/identify/joint_values.hpp"

namespace articam::identify {
namespace {

using math::hat;

/// The problem, as far as it does not change while it is solved.
struct Problem {
  const Object& object;
  const CameraParameters& camera;
  const Constants& constants;
  const Prior& prior;
  double noise;
};

vision::Circle<double> circle_of(const PlacedMarker& marker, double diameter_m, const Moment& moment,
                                 double log_radius) {
  return {moment.T_cam_obj * marker.centre, moment.T_cam_obj.R * marker.normal,
          0.5 * diameter_m * std::exp(log_radius)};
}

std::vector<PlacedMarker> place(const Problem& problem, const Solution& at, const Moment& moment) {
  const Constants& constants = problem.constants;
  return problem.object.place(joint_values(moment, constants, at.constants),
                              at.constants.segment(constants.places(), constants.num_places()));
}

double diameter(const Problem& problem, const Sighting& sighting) {
  return problem.object.markers()[sighting.marker].outer_diameter_m;
}

/// Huber's loss of a distance in deviations: as its square, and beyond kHuber as its magnitude.
double huber(double distance) { return distance < kHuber ? distance * distance : kHuber * (2 * distance - kHuber); }
double huber_weight(double distance) { return distance < kHuber ? 1 : kHuber / distance; }

double prior_cost(const Problem& problem, const VectorXd& x) {
  return (x - problem.prior.mean).cwiseAbs2().dot(problem.prior.information);
}

double cost(const Problem& problem, const Solution& at) {
  const Eye eye{problem.camera, problem.constants.change(at.constants)};
  const double log_radius = at.constants[problem.constants.radius()];
  double sum = prior_cost(problem, at.constants);
  for (const Moment& moment : at.moments) {
    const auto markers = place(problem, at, moment);
    for (const Sighting& sighting : moment.sightings) {
      const auto seen = eye.pixel(circle_of(markers[sighting.marker], diameter(problem, sighting), moment, log_radius));
      if (!seen) return std::numeric_limits<double>::infinity();
      sum += huber((*seen - sighting.pixel).norm() / std::sqrt(sighting.variance_px2) / problem.noise);
    }
  }
  return sum;
}

/// How one sighting moves with the unknowns of its moment (t, rotation, moving joints), and with the shared ones.
struct Rows {
  Eigen::Matrix2Xd own, shared;
};

Rows rows_of(const Constants& constants, const Sight& sight, const PlacedMarker& marker, std::size_t index,
             const Pose<double>& T_cam_obj) {
  const Mat3 R = T_cam_obj.R.toRotationMatrix();
  Rows rows{Eigen::Matrix2Xd::Zero(2, 6 + constants.num_moving()), Eigen::Matrix2Xd::Zero(2, constants.size())};
  rows.own.leftCols<3>() = sight.by_centre;
  rows.own.middleCols<3>(3) =
      -sight.by_centre * hat<double>(R * marker.centre) - sight.by_normal * hat<double>(R * marker.normal);
  for (int value = 0; value < marker.centre_by_value.cols(); ++value) {
    const Vec<double, 2> by_value = sight.by_centre * (R * marker.centre_by_value.col(value)) +
                                    sight.by_normal * (R * marker.normal_by_value.col(value));
    if (constants.moving(value) >= 0) {
      rows.own.col(6 + constants.moving(value)) = by_value;
    } else {
      rows.shared.col(constants.of_value(value)) = by_value;
    }
  }
  if (constants.num_places() > 0) {
    rows.shared.middleCols<3>(constants.places() + static_cast<Eigen::Index>(3 * index)) =
        sight.by_centre * R * marker.R_obj_body;
  }
  rows.shared.middleCols<CameraChange::kSize>(constants.camera()) = sight.by_camera;
  rows.shared.col(constants.radius()) = sight.by_log_radius;
  return rows;
}

/// The standard deviation of each coordinate of residuals, by the median of their lengths, so that false ones do not
/// count; over what fitting the unknowns took away.
double noise_of(std::vector<double> distances, int num_unknowns) {
  if (distances.empty()) return 1;
  const double kMedian = std::sqrt(2 * std::log(2));  // of the length of two standard normal numbers
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  const double equations = 2 * static_cast<double>(distances.size());
  return *middle / kMedian * std::sqrt(equations / std::max(equations - num_unknowns, 1.0));
}

/// The normal equations at a solution; also counts its residuals.
Arrow linearise(const Problem& problem, Solution& at) {
  const Constants& constants = problem.constants;
  const Eye eye{problem.camera, constants.change(at.constants)};
  Arrow arrow{{},
              problem.prior.information.asDiagonal(),
              problem.prior.information.cwiseProduct(problem.prior.mean - at.constants)};
  const int num_own = 6 + constants.num_moving();
  std::vector<double> distances;
  double px2 = 0, weights = 0;
  at.num_sightings = at.num_outliers = 0;
  for (const Moment& moment : at.moments) {
    MomentBlock block{MatrixXd::Zero(num_own, num_own), MatrixXd::Zero(num_own, constants.size()),
                      VectorXd::Zero(num_own)};
    const auto markers = place(problem, at, moment);
    for (const Sighting& sighting : moment.sightings) {
      const PlacedMarker& marker = markers[sighting.marker];
      const auto sight =
          eye.see(circle_of(marker, diameter(problem, sighting), moment, at.constants[constants.radius()]));
      if (!sight) continue;
      const Rows rows = rows_of(constants, *sight, marker, sighting.marker, moment.T_cam_obj);
      const Vec<double, 2> miss = sighting.pixel - sight->pixel;
      const double information = 1 / (sighting.variance_px2 * problem.noise * problem.noise);
      const double distance = miss.norm() * std::sqrt(information), weight = huber_weight(distance);
      block.own += weight * information * rows.own.transpose() * rows.own;
      block.cross += weight * information * rows.own.transpose() * rows.shared;
      block.pull += weight * information * rows.own.transpose() * miss;
      arrow.shared += weight * information * rows.shared.transpose() * rows.shared;
      arrow.pull += weight * information * rows.shared.transpose() * miss;
      distances.push_back(distance);
      weights += weight, px2 += weight * miss.squaredNorm();
      if (weight < 1) ++at.num_outliers;
    }
    arrow.moments.push_back(std::move(block));
  }
  at.num_sightings = static_cast<int>(distances.size());
  const int num_unknowns =
      num_own * static_cast<int>(at.moments.size()) + constants.num_still() + constants.num_places();
  at.noise = std::max(1.0, problem.noise * noise_of(distances, num_unknowns));
  at.rms_px = std::sqrt(px2 / std::max(weights, 1.0));
  return arrow;
}

Solution moved(const Solution& from, const ArrowStep& step, const Constants& constants) {
  Solution to = from;
  to.constants += step.shared;
  for (std::size_t i = 0; i < to.moments.size(); ++i) {
    const VectorXd& own = step.own[i];
    Moment& moment = to.moments[i];
    moment.T_cam_obj.t += own.head<3>();
    moment.T_cam_obj.R = (math::exp_so3<double>(own.segment<3>(3)) * moment.T_cam_obj.R).normalized();
    for (std::size_t j = 0; j < moment.joints.size(); ++j) {
      const int k = constants.moving(static_cast<int>(j));
      if (k >= 0) moment.joints[j] += own[6 + k];
    }
  }
  return to;
}

}  // namespace

Solution begin(const Recording& moments, const Constants& constants) {
  Solution start{moments, VectorXd::Zero(constants.size()), {}};
  for (int i = 0; i < constants.num_still(); ++i) {
    std::vector<double> values;
    for (const Moment& moment : moments)
      values.push_back(moment.joints[static_cast<std::size_t>(constants.still()[static_cast<std::size_t>(i)])]);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    start.constants[i] = *middle;
  }
  return start;
}

Solution adjust(const Object& object, const CameraParameters& camera, const Constants& constants, const Prior& prior,
                const Solution& start) {
  constexpr int kMaxSteps = 60;
  constexpr double kLeastGain = 0.01, kLeastShare = 1e-5, kMostDamping = 1e6;  // 0.01: a tenth of a deviation
  const Problem problem{object, camera, constants, prior, start.noise};
  Solution best = start;
  best.converged = false;
  double lowest = cost(problem, best), damping = 1e-4;
  for (int i = 0; i < kMaxSteps && !best.converged && std::isfinite(lowest); ++i) {
    const Arrow arrow = linearise(problem, best);
    for (; damping < kMostDamping; damping *= 10) {
      const Solution next = moved(best, arrow.solve(damping), constants);
      const double value = cost(problem, next);
      if (!(value <= lowest)) continue;
      best = next;
      best.converged = lowest - value <= std::max(kLeastGain, kLeastShare * lowest);
      lowest = value;
      break;
    }
    if (!(damping < kMostDamping)) best.converged = true;  // no step leads down
    damping = std::max(damping / 10, 1e-9);
  }
  best.information = linearise(problem, best).reduced();
  return best;
}

MatrixXd information_at(const Object& object, const CameraParameters& camera, const Constants& constants,
                        const Prior& prior, Solution solution) {
  return linearise({object, camera, constants, prior, solution.noise}, solution).reduced();
}

}  // namespace articam::identify
