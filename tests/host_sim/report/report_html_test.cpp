#include "host_sim/report/report_html.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/report/page_words.hpp"
#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

using test::count;

const Figure kFigure{"name", "caption",
                     "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"><image "
                     "href=\"data:image/png;base64,\"/></svg>\n"};

std::string page(const RunRecord& run, const std::vector<FeedbackRun>& feedbacks) {
  const Figures figures{std::vector<Figure>(7, kFigure), std::vector<Figure>(1, kFigure),
                        std::vector<Figure>(3, kFigure)};
  return report_html({run, {kFigure}, feedbacks}, evaluate(run), figures);
}

TEST(ReportHtml, NeedsNothingFromOutside) {
  const std::string html = page(test::late_run(), test::pulls());
  for (const char* word : {"http:", "https:", "src=", "<link", "<script", "<?xml", "url("}) {
    EXPECT_EQ(count(html, word), 0u) << word;
  }
  EXPECT_EQ(count(html, "href="), count(html, "href=\"data:image/png;base64,"));
}

TEST(ReportHtml, ShowsEveryPictureAndFigureUnderItsName) {
  const std::string html = page(test::late_run(), test::pulls());
  EXPECT_EQ(count(html, "<figure id="), 12u);
  EXPECT_EQ(count(html, "</figure>"), 12u);
}

TEST(ReportHtml, SpeaksOfTheRobotOnlyWhereThereIsOne) {
  const std::string robot = "What the robot made of it";
  EXPECT_EQ(count(page(test::late_run(), {}), robot), 0u);
  EXPECT_EQ(count(page(test::late_run(), test::pulls()), robot), 1u);
}

TEST(ReportHtml, HoldsTheOtherModeAgainstTheRuns) {
  RunRecord run = test::late_run();
  EXPECT_EQ(count(page(run, {}), "<th>paper's mode</th>"), 0u);
  run.rival_mode = "paper";
  EXPECT_EQ(count(page(run, {}), "<th>paper's mode</th>"), 1u);
}

TEST(ReportHtml, IsAlsoMadeOfARunThatNeverSawAnything) {
  EXPECT_NE(page(test::blind_run(), {}).find("tracked in 0 of"), std::string::npos);
}

}  // namespace
}  // namespace articam::sim
