#include "tools/listen/line_output.hpp"

#include <gtest/gtest.h>

#include "tests/tools/listen/heard_estimate.hpp"

namespace articam::listen {
namespace {

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Line, NamesStatusReasonJointsAndAge) {
  test::Random random{29};
  test::MadeUp made_up{random};
  auto& e = made_up.estimate;
  e.status = tracker::TrackingStatus::degraded, e.reason = tracker::Reason::weak_joint;
  e.frame = 371, e.joints[1] = 0.12345, e.rms_px = 0.25;
  made_up.model.joint_kinds[0] = model::JointKind::revolute;
  made_up.model.joint_kinds[1] = model::JointKind::prismatic;
  const std::string text = line(made_up.heard());
  EXPECT_TRUE(says(text, "1.500 s  frame 371 ")) << text;
  EXPECT_TRUE(says(text, "degraded (weak_joint)")) << text;
  EXPECT_TRUE(says(text, "joint_1 0.12345 m  ")) << text;
  EXPECT_TRUE(says(text, " rad  joint_1 ")) << text;
  EXPECT_TRUE(says(text, "6 markers 0.25 px  age 30.0 ms")) << text;
}

TEST(Line, LeavesTheUnitsOpenWhereTheBoardDoesNotTellTheKinds) {
  test::Random random{29};
  test::MadeUp made_up{random};
  made_up.model.joint_kinds.clear();
  made_up.estimate.joints[1] = 0.12345;
  EXPECT_TRUE(says(line(made_up.heard()), "joint_1 0.12345  at "));
}

TEST(Line, ShowsNoNumbersOfAnEstimateThatIsNotValidAndNoExactAgeThatIsNotExact) {
  test::Random random{30};
  test::MadeUp made_up{random};
  test::make_invalid(made_up.estimate);
  Heard heard = made_up.heard();
  heard.times.age_is_exact = false;
  const std::string text = line(heard);
  EXPECT_TRUE(says(text, "lost (few_markers)")) << text;
  EXPECT_TRUE(says(text, "0 markers  age >30.0 ms")) << text;
  EXPECT_FALSE(says(text, "joint_0")) << text;
}

}  // namespace
}  // namespace articam::listen
