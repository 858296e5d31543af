#include "core/tracker/rival.hpp"

#include <gtest/gtest.h>

#include "static_models/registry.hpp"
#include "tests/support/observe.hpp"

namespace articam::tracker {
namespace {

using M = models::PrinterDrawer;
using Configuration = model::Configuration<M, double>;

/// The closed printer, which is flat, turned away a little.
Configuration tilted(double tilt_rad, double z_m) {
  Configuration q;
  q.T_cam_obj.t = {0.02, 0.03, z_m};
  q.T_cam_obj.R = math::exp_so3<double>({tilt_rad, 0.3 * tilt_rad, 0.1});
  q.joints = {0.05, 0.12};
  return q;
}

/// The base's four markers alone: a plane, and the drawer's are not seen.
Matches<M, double> observe_base(const Configuration& q, double noise_px, test::Random& random) {
  auto matches = test::observe<M, double>(q, FeatureKind::imaged_circle, noise_px, &random);
  matches[4].matched = matches[5].matched = false;
  return matches;
}

Consensus<M, double> solved(const Matches<M, double>& matches, const Configuration& near) {
  Consensus<M, double> found;
  found.solution = solve(matches, open_prior<M, double>(near), near, 20);
  return found;
}

TEST(Rival, TakesOverFromTheWrongOneOfTwoMirrorImagesOnceTheFramesHaveDecided) {
  test::Random random{9};
  const Configuration truth = tilted(0.35, 2.0);
  auto wrong = truth;  // the other way to see the plane
  {
    Hypothesis<M, double> seen{.q = truth, .anchor = -1};
    seen.sighting = {0, 0, 0, 0, -1, -1};
    wrong = mirror_image(seen).value();
  }
  Rival<M, double> rival;
  Configuration followed = wrong;
  int taken_over_after = 0;
  for (int frame = 1; frame <= 300 && taken_over_after == 0; ++frame) {
    const auto matches = observe_base(truth, 0.3, random);
    auto found = solved(matches, followed);
    if (rival.challenge(matches, followed, found)) taken_over_after = frame;
    followed = found.solution.q;
  }
  EXPECT_GT(taken_over_after, 0);
  EXPECT_LT(model::difference(truth, followed).segment<3>(3).norm(), 0.1);
}

TEST(Rival, NeverTakesOverFromTheTrueOne) {
  for (const double tilt : {0.1, 0.2, 0.35}) {
    test::Random random{10};
    const Configuration truth = tilted(tilt, 1.5);
    Rival<M, double> rival;
    Configuration followed = truth;
    for (int frame = 0; frame < 600; ++frame) {
      const auto matches = observe_base(truth, 0.3, random);
      auto found = solved(matches, followed);
      EXPECT_FALSE(rival.challenge(matches, followed, found)) << tilt << ' ' << frame;
      followed = found.solution.q;
    }
  }
}

TEST(Rival, MakesTheCovarianceHoldBothWhileNothingIsDecided) {
  test::Random random{11};
  const Configuration truth = tilted(0.3, 2.5);  // so far away that perspective is lost in the noise
  Rival<M, double> rival;
  int undecided = 0, disputed = 0;
  for (int frame = 0; frame < 60; ++frame) {
    const auto matches = observe_base(truth, 0.5, random);
    auto found = solved(matches, truth);
    const auto alone = found.solution.covariance;
    (void)rival.challenge(matches, truth, found);
    if (!rival.stands()) continue;
    ++undecided;
    disputed += found.disputed[3] ? 1 : 0;
    EXPECT_GT(found.solution.covariance(3, 3), alone(3, 3));
  }
  EXPECT_GT(undecided, 10);
  EXPECT_GT(disputed, 5);
}

}  // namespace
}  // namespace articam::tracker
