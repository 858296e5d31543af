#include "tools/identify/identify.hpp"

#include <cmath>

#include "tools/identify/adjust.hpp"
#include "tools/identify/datum.hpp"
#include "tools/identify/joint_values.hpp"
#include "tools/identify/judge_camera.hpp"

namespace articam::identify {
namespace {

std::vector<bool> seen_markers(const Object& object, const Recording& recording) {
  std::vector<bool> seen(static_cast<std::size_t>(object.num_markers()), false);
  for (const Moment& moment : recording) {
    for (const Sighting& sighting : moment.sightings) seen[sighting.marker] = true;
  }
  return seen;
}

Vec<double, 2> outermost(const CameraParameters& camera, const Recording& recording) {
  const Vec<double, 2> axis{camera.cx_px, camera.cy_px};
  Vec<double, 2> farthest = axis;
  for (const Moment& moment : recording) {
    for (const Sighting& sighting : moment.sightings) {
      if ((sighting.pixel - axis).norm() > (farthest - axis).norm()) farthest = sighting.pixel;
    }
  }
  return farthest;
}

Datum hold(const Object& object, const Constants& constants, const Solution& solution) {
  const Moment& middle = solution.moments[solution.moments.size() / 2];
  return hold_datum(object, constants,
                    {solution.constants, solution.information, joint_values(middle, constants, solution.constants),
                     seen_markers(object, solution.moments)});
}

/// The same solution where markers' places are among the constants.
Solution with_places(const Solution& solution, const Constants& without, const Constants& with) {
  Solution wider = solution;
  wider.constants = VectorXd::Zero(with.size());
  wider.constants.head(with.places()) = solution.constants.head(without.places());
  wider.constants.tail(with.size() - with.camera()) = solution.constants.tail(without.size() - without.camera());
  return wider;
}

/// Whether the recording tells every marker that it saw to kTold_m. Resting ones do not: two numbers a marker and view
/// are then all there is for three.
bool tells_places(const Constants& constants, const Datum& datum, const std::vector<bool>& seen) {
  constexpr double kTold_m = 2e-3;
  for (std::size_t m = 0; m < seen.size(); ++m) {
    const auto row = constants.places() + static_cast<Eigen::Index>(3 * m);
    if (seen[m] && datum.covariance.diagonal().segment<3>(row).maxCoeff() > kTold_m * kTold_m) return false;
  }
  return true;
}

struct Identified {
  Constants constants;
  Solution solution;
  Datum datum;
};

/// First with all markers where the model has them. Then their places are set free, if the recording tells them, and
/// adjusted twice: the first time tells where along the held directions they belong.
Identified solve(const Object& object, const CameraParameters& camera, const Recording& recording,
                 const Request& request) {
  const Constants lengths{object, {request.still, false}}, all{object, request};
  Recording moments = spread_out(recording, kMostMoments);
  mind_repetition(moments);
  Solution solution = begin(moments, lengths);
  for (int i = 0; i < 2; ++i) solution = adjust(object, camera, lengths, prior_of(lengths, camera), solution);
  const Identified held{lengths, solution, hold(object, lengths, solution)};
  if (!request.places) return held;

  Prior prior = prior_of(all, camera);
  solution = with_places(solution, lengths, all);
  const double noise2 = solution.noise * solution.noise;  // what wrong places do to it is no noise
  solution.information = noise2 * information_at(object, camera, all, prior, solution);
  if (!tells_places(all, hold(object, all, solution), seen_markers(object, solution.moments))) return held;
  solution = adjust(object, camera, all, prior, solution);
  const VectorXd shift = hold(object, all, solution).shift;
  solution.constants += shift;
  prior.mean.segment(all.places(), all.num_places()) += shift.segment(all.places(), all.num_places());
  solution = adjust(object, camera, all, prior, solution);
  return {all, solution, hold(object, all, solution)};
}

}  // namespace

std::optional<Findings> identify(const Object& object, const CameraParameters& camera, const Recording& recording,
                                 const Request& request) {
  if (recording.size() < kLeastMoments) return std::nullopt;
  const auto [constants, solution, datum] = solve(object, camera, recording, request);
  const VectorXd x = solution.constants + datum.shift;

  Findings findings;
  for (int i = 0; i < constants.num_still(); ++i) {
    const auto& row = object.values()[static_cast<std::size_t>(constants.still()[static_cast<std::size_t>(i)])];
    findings.lengths.push_back(
        {std::string{row.name}, row.kind == model::JointKind::prismatic, x[i], std::sqrt(datum.covariance(i, i))});
  }
  const std::vector<bool> seen = seen_markers(object, solution.moments);
  for (int m = 0; 3 * m < constants.num_places(); ++m) {
    const int row = constants.places() + 3 * m;
    const auto i = static_cast<std::size_t>(m);
    findings.places.push_back({std::string{object.markers()[i].name}, x.segment<3>(row),
                               datum.covariance.block<3, 3>(row, row), seen[i], datum.reference[i]});
  }
  findings.camera = judge_camera(camera, constants, x, datum.covariance, outermost(camera, solution.moments));
  findings.num_held = static_cast<int>(datum.held.cols());
  findings.num_moments = static_cast<int>(solution.moments.size());
  findings.num_sightings = solution.num_sightings;
  findings.num_outliers = solution.num_outliers;
  findings.rms_px = solution.rms_px;
  findings.noise = solution.noise;
  findings.converged = solution.converged;
  return findings;
}

}  // namespace articam::identify
