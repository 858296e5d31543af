#include "host_sim/report/figures.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

TEST(Figures, AreThePapersFive) {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "the program gnuplot is not installed";
  std::vector<Figure> figures;
  ASSERT_EQ(draw_figures(test::late_run(), figures), Status::ok);
  ASSERT_EQ(figures.size(), 5u);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    EXPECT_NE(figures[i].caption.find("figure " + std::to_string(3 + i)), std::string::npos);
    EXPECT_EQ(figures[i].svg.rfind("<svg", 0), 0u);
    EXPECT_NE(figures[i].svg.find("</svg>"), std::string::npos);
    EXPECT_EQ(figures[i].svg.find("nan"), std::string::npos);
  }
}

TEST(Figures, SayWhenGnuplotIsMissing) {
  const char* path = std::getenv("PATH");
  const std::string kept = path == nullptr ? "" : path;
  setenv("PATH", "/nonexistent", 1);
  std::vector<Figure> figures;
  const Status status = draw_figures(test::late_run(), figures);
  setenv("PATH", kept.c_str(), 1);
  EXPECT_EQ(status, Status::io_error);
}

}  // namespace
}  // namespace articam::sim
