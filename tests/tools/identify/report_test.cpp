#include "tools/identify/report.hpp"

#include <gtest/gtest.h>

namespace articam::identify {
namespace {

TEST(Report, SaysOfACalibrationWhatAPersonCanActOn) {
  Findings findings;
  findings.camera = {{Judgement::Part::focal_length, -0.008, 0.0007, 2.4, true},
                     {Judgement::Part::principal_x, 0.1, 0.2, 0.1, true},
                     {Judgement::Part::distortion, 0.1, 9, 0.1, false}};
  const std::string text = to_text(findings, "camera.yaml");
  EXPECT_NE(text.find("of camera.yaml is 0.8 % too long (11 sigma): calibrate again"), std::string::npos) << text;
  EXPECT_NE(text.find("agrees, within 0.4 px"), std::string::npos) << text;
  EXPECT_NE(text.find("not told by this recording"), std::string::npos) << text;
}

TEST(Report, NamesDisplacedMarkersAndThoseNotSeen) {
  Findings findings;
  findings.places = {{"left", {0.003, 0, 0}, Mat3::Identity() * 1e-10, true, false},
                     {"right", Vec3::Zero(), Mat3::Identity() * 1e-4, false, false}};
  findings.num_held = 6;
  const std::string text = to_text(findings, "camera.yaml");
  EXPECT_NE(text.find("+3.000 +0.000 +0.000 +- 0.010 0.010 0.010   displaced"), std::string::npos) << text;
  EXPECT_NE(text.find("not seen"), std::string::npos) << text;
  EXPECT_NE(text.find("6 directions cannot be told"), std::string::npos) << text;
}

TEST(Report, SaysWhereResidualsContradictTheModel) {
  Findings findings;
  findings.noise = 30;
  EXPECT_NE(to_text(findings, "camera.yaml").find("30 times"), std::string::npos);
  findings.noise = 1.2;
  EXPECT_EQ(to_text(findings, "camera.yaml").find("times"), std::string::npos);
}

TEST(Judgement, OfAnErrorThatNobodyWouldSeeIsNotWrong) {
  EXPECT_TRUE((Judgement{Judgement::Part::aspect, 0.01, 0.001, 2, true}).wrong());
  EXPECT_FALSE((Judgement{Judgement::Part::aspect, 0.01, 0.001, 0.05, true}).wrong());
  EXPECT_FALSE((Judgement{Judgement::Part::aspect, 0.01, 0.005, 2, true}).wrong());
  EXPECT_FALSE((Judgement{Judgement::Part::aspect, 0.01, 0.001, 2, false}).wrong());
}

}  // namespace
}  // namespace articam::identify
