#include "host_sim/report/figures.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

bool gnuplot_is_missing() { return std::system("gnuplot --version >/dev/null 2>&1") != 0; }

TEST(Figures, AreThePapersFiveWithErrorsAndCounts) {
  if (gnuplot_is_missing()) GTEST_SKIP() << "the program gnuplot is not installed";
  Figures figures;
  ASSERT_EQ(draw_figures(test::late_run(), {}, figures), Status::ok);
  for (const char* number : {"3", "4", "5", "6", "7"}) {
    int count = 0;
    for (const Figure& figure : figures.paper) {
      count += figure.caption.find(std::string("Figure ") + number + ".") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(count, 1) << "figure " << number;
  }
  EXPECT_TRUE(figures.robot.empty());
  EXPECT_EQ(figures.counts.size(), 3u);
  for (const std::vector<Figure>* chapter : {&figures.paper, &figures.counts}) {
    for (const Figure& figure : *chapter) {
      EXPECT_NE(figure.svg.find("</svg>"), std::string::npos) << figure.name;
      EXPECT_EQ(figure.svg.find("nan"), std::string::npos) << figure.name;
    }
  }
}

TEST(Figures, HaveOneOfTheRobotByEveryFeedback) {
  if (gnuplot_is_missing()) GTEST_SKIP() << "the program gnuplot is not installed";
  RunRecord run = test::late_run();
  run.pulled_joint = 0;
  Figures figures;
  ASSERT_EQ(draw_figures(run, test::pulls(), figures), Status::ok);
  ASSERT_EQ(figures.robot.size(), 1u);
  for (const char* label : {"by default", "by truth", "command"}) {
    EXPECT_NE(figures.robot[0].svg.find(label), std::string::npos) << label;
  }
  EXPECT_EQ(figures.robot[0].svg.find("by svd"), std::string::npos) << "it has no samples";
}

TEST(Figures, AreDrawnOfARunThatNeverSawAnything) {
  if (gnuplot_is_missing()) GTEST_SKIP() << "the program gnuplot is not installed";
  Figures figures;
  EXPECT_EQ(draw_figures(test::blind_run(), {}, figures), Status::ok);
}

TEST(Figures, SayWhenGnuplotIsMissing) {
  const char* path = std::getenv("PATH");
  const std::string kept = path == nullptr ? "" : path;
  setenv("PATH", "/nonexistent", 1);
  Figures figures;
  const Status status = draw_figures(test::late_run(), {}, figures);
  setenv("PATH", kept.c_str(), 1);
  EXPECT_EQ(status, Status::io_error);
}

}  // namespace
}  // namespace articam::sim
