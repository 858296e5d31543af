#include "hal/wire/message_reader.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

using wire::Fault;

wire::EstimateMessage good() {
  test::Random random{5};
  wire::EstimateMessage m = test::random_estimate(random);
  test::fill_pose(m.t_base_obj, random);
  return m;
}
/// The verdict on a good estimate after one change.
template <class Change>
Fault after(Change change) {
  wire::EstimateMessage m = good();
  change(m);
  return wire::check(m);
}

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(MessageCheck, PassesAGoodEstimateAndOneThatSaysThereIsNone) {
  EXPECT_EQ(wire::check(good()), Fault::none);
  EXPECT_EQ(wire::check(wire::EstimateMessage{}), Fault::none);
}

TEST(MessageCheck, FindsOneNumberThatIsNotFiniteWhereverItIs) {
  for (const double bad : {kInf, -kInf, kNaN}) {
    EXPECT_EQ(after([&](auto& m) { m.rms_px = bad; }), Fault::inconsistent);
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_EQ(after([&](auto& m) { m.t_cam_obj[i] = bad; }), Fault::inconsistent);
      EXPECT_EQ(after([&](auto& m) { m.t_base_obj[i] = bad; }), Fault::inconsistent);
    }
    EXPECT_EQ(after([&](auto& m) { m.joints[1] = bad; }), Fault::inconsistent);
    EXPECT_EQ(after([&](auto& m) { m.velocity[7] = bad; }), Fault::inconsistent);
    EXPECT_EQ(after([&](auto& m) { m.covariance[35] = bad; }), Fault::inconsistent);
  }
}

TEST(MessageCheck, FindsListsThatDoNotFitTogether) {
  EXPECT_EQ(after([](auto& m) { m.joints.clear(); }), Fault::inconsistent);
  EXPECT_EQ(after([](auto& m) { m.velocity.clear(); }), Fault::inconsistent);
  EXPECT_EQ(after([](auto& m) { m.observability.clear(); }), Fault::inconsistent);
  EXPECT_EQ(after([](auto& m) { (void)m.covariance.push_back(0); }), Fault::inconsistent);
  EXPECT_EQ(after([](auto& m) { m.t_cam_obj.clear(); }), Fault::inconsistent);
  EXPECT_EQ(after([](auto& m) { m.t_base_obj.clear(); }), Fault::none) << "where the camera stands may be unknown";
}

TEST(MessageCheck, FindsANegativeVarianceAndLeavesCovariancesTheirSign) {
  std::size_t refused = 0;
  for (std::size_t k = 0; k < wire::triangle_size(8); ++k) {
    refused += after([&](auto& m) { m.covariance[k] = -1e-9; }) == Fault::inconsistent ? 1u : 0u;
  }
  EXPECT_EQ(refused, 8u) << "one for each degree of freedom";
  for (const std::size_t diagonal : {0u, 8u, 15u, 21u, 26u, 30u, 33u, 35u}) {
    EXPECT_EQ(after([&](auto& m) { m.covariance[diagonal] = -1e-9; }), Fault::inconsistent);
    EXPECT_EQ(after([&](auto& m) { m.covariance[diagonal] = 0; }), Fault::none);
  }
}

TEST(MessageCheck, FindsNumbersWhereThereIsNoEstimate) {
  EXPECT_EQ(after([](auto& m) { m.valid = false; }), Fault::inconsistent);
}

TEST(MessageCheck, FindsAQuaternionThatIsNone) {
  EXPECT_EQ(after([](auto& m) { m.t_cam_obj[3] += 2; }), Fault::inconsistent);
  EXPECT_EQ(after([](auto& m) {
              for (std::size_t i = 3; i < 7; ++i) m.t_base_obj[i] = 0;
            }),
            Fault::inconsistent);
}

TEST(MessageCheck, FindsAnEstimateSentBeforeItWasSeen) {
  EXPECT_EQ(after([](auto& m) { m.t_send.ns = m.t_capture.ns - 1; }), Fault::inconsistent);
}

TEST(MessageCheck, FindsNamesThatWouldUpsetATerminalOrATable) {
  test::Random random{7};
  const wire::ModelMessage good_model = test::random_model(random);
  for (const char* const name : {"", "a,b", "a\"b", "a\nb", "\033[2J", "a\177"}) {
    wire::ModelMessage m = good_model;
    m.name = test::text_of(name);
    EXPECT_EQ(wire::check(m), Fault::inconsistent) << name;
    m = good_model, m.joint_names[1] = test::text_of(name);
    EXPECT_EQ(wire::check(m), Fault::inconsistent) << name;
  }
  wire::ModelMessage m = good_model;
  m.joint_names[0] = test::text_of("t\u00fcr 1");
  EXPECT_EQ(wire::check(m), Fault::none);
}

TEST(MessageCheck, FindsKindsThatAreNotAsManyAsTheJoints) {
  test::Random random{8};
  wire::ModelMessage m = test::random_model(random, 2);
  EXPECT_EQ(wire::check(m), Fault::none);
  m.joint_kinds.clear();
  EXPECT_EQ(wire::check(m), Fault::none) << "a board that does not tell them";
  ASSERT_TRUE(m.joint_kinds.push_back(model::JointKind::revolute));
  EXPECT_EQ(wire::check(m), Fault::inconsistent);
}

TEST(Unit, IsThatOfTheJointsKind) {
  using enum model::JointKind;
  wire::ModelMessage m;
  for (const auto kind : {revolute, continuous, prismatic}) ASSERT_TRUE(m.joint_kinds.push_back(kind));
  EXPECT_EQ(wire::unit(m, 0), "rad");
  EXPECT_EQ(wire::unit(m, 1), "rad");
  EXPECT_EQ(wire::unit(m, 2), "m");
  EXPECT_EQ(wire::unit(m, 3), "") << "not told";
}

TEST(MessageCheck, FindsAModelWithARateOrAPoseThatIsNone) {
  test::Random random{6};
  wire::ModelMessage m = test::random_model(random);
  test::fill_pose(m.t_base_cam, random);
  EXPECT_EQ(wire::check(m), Fault::none);
  m.rate_hz = kNaN;
  EXPECT_EQ(wire::check(m), Fault::inconsistent);
  m.rate_hz = 30, m.t_base_cam[6] = kInf;
  EXPECT_EQ(wire::check(m), Fault::inconsistent);
}

}  // namespace
}  // namespace articam
