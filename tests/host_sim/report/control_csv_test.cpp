#include "host_sim/report/control_csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/host_sim/report/page_words.hpp"
#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

TEST(ControlCsv, HasARowForEverySampleAndACellForEveryHeading) {
  const auto samples = test::pulls()[0].samples;
  std::istringstream text{control_csv(samples)};
  std::string line;
  std::size_t lines = 0;
  for (; std::getline(text, line); ++lines) EXPECT_EQ(std::ranges::count(line, ','), 7) << line;
  EXPECT_EQ(lines, 1 + samples.size());
}

TEST(FeedbackText, CountsAJointThatSlidesInMillimetresAndOneThatTurnsInMilliradians) {
  RunRecord run = test::late_run();
  run.pulled_joint = 0;
  const std::string slides = feedback_text(run, test::pulls());
  run.joint_is_length[0] = false;
  const std::string turns = feedback_text(run, test::pulls());
  EXPECT_EQ(test::count(slides, " mm"), 5u);
  EXPECT_EQ(test::count(slides, "mrad"), 0u);
  EXPECT_EQ(test::count(turns, "mrad"), 5u);
  EXPECT_EQ(test::count(turns, " mm"), 0u);
  EXPECT_EQ(test::count(turns, "knows no joint"), 1u) << "the SVD baseline";
}

}  // namespace
}  // namespace articam::sim
