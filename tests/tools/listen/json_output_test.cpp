#include "tools/listen/json_output.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/udp_ear.hpp"
#include "tests/tools/listen/heard_estimate.hpp"

namespace articam::listen {
namespace {

TEST(JsonOutput, SaysEveryNumberByItsName) {
  test::Random random{25};
  const test::MadeUp made_up{random};
  const auto& e = made_up.estimate;
  const auto json = nlohmann::json::parse(to_json(made_up.heard()));
  EXPECT_DOUBLE_EQ(json["timestamp"], 1'700'000'000.01);
  EXPECT_EQ(json["status"], static_cast<int>(e.status));
  EXPECT_EQ(json["status_name"], name(e.status));
  EXPECT_EQ(json["reason_name"], name(e.reason));
  EXPECT_EQ(json["frame"], e.frame);
  EXPECT_EQ(json["matched"], e.matched);
  EXPECT_EQ(json["rms_px"], e.rms_px);
  EXPECT_EQ(json["age_s"], 0.03);
  EXPECT_EQ(json["joints"]["joint_1"], e.joints[1]);
  EXPECT_EQ(json["units"]["joint_1"], wire::unit(made_up.model, 1));
  EXPECT_EQ(json["velocity"]["rx"], e.velocity[3]);
  EXPECT_EQ(json["velocity"]["joint_0"], e.velocity[6]);
  EXPECT_EQ(json["std"]["joint_0"], std::sqrt(made_up.covariance(6, 6)));
  EXPECT_EQ(json["t_cam_obj"]["qw"], e.t_cam_obj[3]);
  EXPECT_EQ(json["t_base_obj"]["pz"], e.t_base_obj[2]);
}

TEST(JsonOutput, LeavesOutWhatIsNotKnown) {
  test::Random random{26};
  test::MadeUp made_up{random};
  made_up.model.joint_kinds.clear();
  EXPECT_FALSE(nlohmann::json::parse(to_json(made_up.heard())).contains("units"));
  test::make_invalid(made_up.estimate);
  const auto json = nlohmann::json::parse(to_json(made_up.heard()));
  EXPECT_EQ(json["status_name"], "lost");
  EXPECT_EQ(json["valid"], false);
  for (const char* absent : {"joints", "velocity", "std", "t_cam_obj", "t_base_obj", "rms_px"}) {
    EXPECT_FALSE(json.contains(absent)) << absent;
  }
}

TEST(JsonOutput, SurvivesNamesThatAreNoText) {
  test::Random random{27};
  test::MadeUp made_up{random};
  made_up.model.joint_names[0] = test::text_of("\xff\"\n");
  EXPECT_TRUE(nlohmann::json::accept(to_json(made_up.heard())));
}

TEST(JsonOutput, SendsOneDatagramAnEstimateAndDoesNotMindThatNobodyListens) {
  test::Random random{28};
  const test::MadeUp made_up{random};
  wire::Address address;
  {
    const test::UdpEar ear;
    ASSERT_EQ(wire::parse_address("udp://127.0.0.1:" + std::to_string(ear.port()), address), "");
    JsonOutput output;
    ASSERT_EQ(output.open(address), "");
    EXPECT_EQ(output.take(made_up.heard()), "");
    const auto datagram = ear.hear();
    EXPECT_EQ(std::string(datagram.begin(), datagram.end()), to_json(made_up.heard()));
  }
  JsonOutput output;
  ASSERT_EQ(output.open(address), "");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(output.take(made_up.heard()), "");
}

}  // namespace
}  // namespace articam::listen
