#include "hal/receiver/prediction.hpp"

#include <gtest/gtest.h>

#include "core/model/configuration.hpp"
#include "hal/wire/message_reader.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;

Pose<double> pose_of(const wire::PoseNumbers& x) {
  return {Quat<double>{x[3], x[4], x[5], x[6]}, Vec<double, 3>{x[0], x[1], x[2]}};
}
double distance(const Pose<double>& a, const Pose<double>& b) { return (a.t - b.t).norm() + a.R.angularDistance(b.R); }

wire::EstimateMessage estimate(test::Random& random) {
  wire::EstimateMessage m = test::random_estimate(random);
  test::fill_pose(m.t_base_obj, random);
  return m;
}

TEST(Prediction, IsTheTrackersOwnIntegration) {
  test::Random random{41};
  for (int trial = 0; trial < 1000; ++trial) {
    wire::EstimateMessage m = estimate(random);
    const double dt_s = random.uniform(0, 0.2);
    model::Configuration<M, double> q;
    Vec<double, 8> step;
    q.T_cam_obj = pose_of(m.t_cam_obj);
    for (int i = 0; i < 8; ++i) step[i] = dt_s * m.velocity[static_cast<std::size_t>(i)];
    for (int j = 0; j < 2; ++j) q.joints[j] = m.joints[static_cast<std::size_t>(j)];
    const auto expected = model::integrate<M, double>(q, step);
    ASSERT_TRUE(receiver::predict(m, dt_s));
    // Numbers of the size of 1 and a dozen roundings; an angle near 0 from a dot product loses half the digits.
    ASSERT_LT((pose_of(m.t_cam_obj).t - expected.T_cam_obj.t).norm(), 1e-14) << "seed 41, trial " << trial;
    ASSERT_LT((pose_of(m.t_cam_obj).R.coeffs() - expected.T_cam_obj.R.coeffs()).norm(), 1e-14);
    for (int j = 0; j < 2; ++j) ASSERT_NEAR(m.joints[static_cast<std::size_t>(j)], expected.joints[j], 1e-14);
  }
}

TEST(Prediction, TheCameraStandsStillInTheRobotsFrame) {
  test::Random random{42};
  for (int trial = 0; trial < 1000; ++trial) {
    wire::EstimateMessage m = estimate(random);
    const Pose<double> before = pose_of(m.t_base_obj) * pose_of(m.t_cam_obj).inverse();
    ASSERT_TRUE(receiver::predict(m, 0.1));
    const Pose<double> after = pose_of(m.t_base_obj) * pose_of(m.t_cam_obj).inverse();
    ASSERT_LT(distance(before, after), 1e-7) << "seed 42, trial " << trial;
  }
}

TEST(Prediction, TwoHalvesAreTheWholeAndNoTimeIsNoMotion) {
  test::Random random{43};
  wire::EstimateMessage whole = estimate(random);
  wire::EstimateMessage halves = whole, still = whole;
  ASSERT_TRUE(receiver::predict(whole, 0.1));
  ASSERT_TRUE(receiver::predict(halves, 0.05) && receiver::predict(halves, 0.05));
  EXPECT_LT(distance(pose_of(whole.t_cam_obj), pose_of(halves.t_cam_obj)), 1e-7);
  const Pose<double> before = pose_of(still.t_cam_obj);
  ASSERT_TRUE(receiver::predict(still, 0));
  EXPECT_LT(distance(before, pose_of(still.t_cam_obj)), 1e-7);
}

TEST(Prediction, LeavesAnEstimateThatIsNotValidAlone) {
  wire::EstimateMessage m;
  EXPECT_TRUE(receiver::predict(m, 0.1));
  EXPECT_TRUE(m.t_cam_obj.empty());
}

TEST(Prediction, NeverLeavesANumberThatIsNotFinite) {
  test::Random random{44};
  for (std::size_t i = 0; i < 8; ++i) {
    for (const double huge : {1e308, -1e308, 1e200, 1e9}) {
      wire::EstimateMessage m = estimate(random);
      m.velocity[i] = huge;
      const std::string before = test::by_protobuf(m);
      const bool done = receiver::predict(m, 5);
      EXPECT_EQ(wire::check(m), wire::Fault::none) << i << ' ' << huge;
      EXPECT_TRUE(done || test::by_protobuf(m) == before) << "a failure changes nothing";
    }
  }
}

}  // namespace
}  // namespace articam
