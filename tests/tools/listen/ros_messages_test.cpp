#include "tools/listen/ros_messages.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "tests/tools/listen/heard_estimate.hpp"
#include "tests/tools/listen/mcap_reader.hpp"

namespace articam::listen {
namespace {

class RosMessages : public testing::Test {
 protected:
  using Put = void (*)(CdrWriter&, const Heard&);

  /// Reads the header away.
  test::CdrReader read(Put put, const std::string& frame_id) {
    CdrWriter writer;
    put(writer, made_up_.heard());
    const auto bytes = writer.bytes();
    message_.assign(bytes.begin(), bytes.end());
    test::CdrReader reader{message_};
    EXPECT_EQ(reader.number<std::int32_t>(), 1'700'000'000);
    EXPECT_EQ(reader.number<std::uint32_t>(), 10'000'000u);
    EXPECT_EQ(reader.text(), frame_id);
    return reader;
  }
  static std::vector<double> list(const auto& numbers) { return {numbers.begin(), numbers.end()}; }

  test::Random random_{21};
  test::MadeUp made_up_{random_};
  std::string message_;
};

TEST_F(RosMessages, JointStateHoldsNamesPositionsAndRates) {
  auto reader = read(put_joint_state, "");
  EXPECT_EQ(reader.texts(), (std::vector<std::string>{"joint_0", "joint_1"}));
  EXPECT_EQ(reader.doubles(), list(made_up_.estimate.joints));
  const auto& rates = made_up_.estimate.velocity;
  EXPECT_EQ(reader.doubles(), (std::vector<double>{rates[6], rates[7]}));
  EXPECT_EQ(reader.doubles(), std::vector<double>{});
  EXPECT_TRUE(reader.at_end());
}

TEST_F(RosMessages, PoseIsThatOfTheCameraWithTheQuaternionInTheOrderOfRos) {
  auto reader = read(put_pose_in_camera, "camera");
  const auto& T = made_up_.estimate.t_cam_obj;
  EXPECT_EQ(reader.doubles(7), (std::vector<double>{T[0], T[1], T[2], T[4], T[5], T[6], T[3]}));
  for (int i = 0; i < 36; ++i) {
    const double sent = made_up_.covariance(i / 6, i % 6);
    EXPECT_NEAR(reader.number<double>(), sent, 1e-21) << i;  // of 1e-6: turned by the identity, to the last bits
  }
  EXPECT_TRUE(reader.at_end());
}

TEST_F(RosMessages, PoseInTheBaseHasItsCovarianceTurnedWithIt) {
  auto reader = read(put_pose_in_base, "base");
  const auto& T = made_up_.estimate.t_base_obj;
  EXPECT_EQ(reader.doubles(7), (std::vector<double>{T[0], T[1], T[2], T[4], T[5], T[6], T[3]}));
  const Mat<double, 3, 3> R = made_up_.T_base_cam.R.toRotationMatrix();
  const Mat<double, 6, 6> C = made_up_.covariance.topLeftCorner<6, 6>();
  const auto rows = reader.doubles(36);
  for (int i = 0; i < 6; i += 3) {
    for (int k = 0; k < 6; k += 3) {
      const Mat<double, 3, 3> turned = R * C.block<3, 3>(i, k) * R.transpose();
      for (int m = 0; m < 9; ++m) {
        const auto at = static_cast<std::size_t>(6 * (i + m / 3) + k + m % 3);
        EXPECT_NEAR(rows[at], turned(m / 3, m % 3), 1e-20);  // of 1e-6, through two rotations
      }
    }
  }
  EXPECT_TRUE(reader.at_end());
}

TEST_F(RosMessages, EstimateHoldsAllThatWasSent) {
  const auto& e = made_up_.estimate;
  auto reader = read(put_estimate, "camera");
  EXPECT_EQ(reader.number<std::uint64_t>(), e.session);
  EXPECT_EQ(reader.number<std::uint64_t>(), e.model_hash);
  EXPECT_EQ(reader.text(), "cabinet");
  EXPECT_EQ(reader.number<std::uint32_t>(), e.number);
  EXPECT_EQ(reader.number<std::uint32_t>(), e.frame);
  EXPECT_EQ(reader.number<std::int64_t>(), e.t_capture.ns);
  EXPECT_EQ(reader.number<std::int64_t>(), e.t_send.ns);
  EXPECT_EQ(reader.number<double>(), 0.03);
  EXPECT_EQ(reader.number<std::uint8_t>(), 1) << "age_is_exact";
  EXPECT_EQ(reader.number<std::uint8_t>(), static_cast<int>(e.status));
  EXPECT_EQ(reader.number<std::uint8_t>(), static_cast<int>(e.reason));
  EXPECT_EQ(reader.text(), name(e.status));
  EXPECT_EQ(reader.text(), name(e.reason));
  EXPECT_EQ(reader.number<std::uint8_t>(), 1) << "valid";
  EXPECT_EQ(reader.doubles(), list(e.t_cam_obj));
  EXPECT_EQ(reader.texts(), (std::vector<std::string>{"joint_0", "joint_1"}));
  EXPECT_EQ(reader.doubles(), list(e.joints));
  EXPECT_EQ(reader.doubles(), list(e.velocity));
  EXPECT_EQ(reader.doubles(), list(e.covariance));
  ASSERT_EQ(reader.number<std::uint32_t>(), e.observability.size());
  for (const auto x : e.observability) EXPECT_EQ(reader.number<std::uint8_t>(), static_cast<int>(x));
  EXPECT_EQ(reader.number<std::uint32_t>(), e.matched);
  EXPECT_EQ(reader.number<double>(), e.rms_px);
  EXPECT_EQ(reader.doubles(), list(e.t_base_obj));
  EXPECT_TRUE(reader.at_end());
}

// A reader refuses a schema that names a message without defining it.
TEST_F(RosMessages, DefinitionsDefineEveryMessageThatTheyUse) {
  for (const MessageType* type : {&kJointState, &kPoseWithCovarianceStamped, &kEstimate}) {
    std::istringstream text{std::string{type->definition}};
    std::set<std::string> used, defined;
    for (std::string line, before; std::getline(text, line); before = line) {
      const std::string word = line.substr(0, line.find_first_of(" ["));
      if (word.find('/') != std::string::npos) used.insert(word);
      if (word == "MSG:") {
        EXPECT_EQ(before, std::string(80, '='));
        defined.insert(line.substr(5));
      }
    }
    EXPECT_EQ(used, defined) << type->name;
    EXPECT_FALSE(used.empty());
  }
}

}  // namespace
}  // namespace articam::listen
