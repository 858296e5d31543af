#include "host_sim/report/run_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

TEST(WriteReport, EndsAtTheFirstFileThatCannotBeWritten) {
  const RunRecord run = test::late_run();
  std::vector<std::string> written;
  const auto write = [&](const std::filesystem::path& path, const std::string&) {
    written.push_back(path.filename().string());
    return written.size() < 2 ? std::string{} : std::string("disk full");
  };
  EXPECT_EQ(write_report("nowhere", {run, {}, {}}, evaluate(run), write), "disk full");
  EXPECT_EQ(written, (std::vector<std::string>{"truth.csv", "metrics.json"}));
}

TEST(WriteReport, WritesThePageLastAfterEveryFigureOnItsOwn) {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "the program gnuplot is not installed";
  const RunRecord run = test::late_run();
  std::vector<std::string> written;
  const auto write = [&](const std::filesystem::path& path, const std::string&) {
    written.push_back(path.filename().string());
    return std::string{};
  };
  EXPECT_EQ(write_report("nowhere", {run, {}, {}}, evaluate(run), write), "");
  ASSERT_GT(written.size(), 8u);
  EXPECT_EQ(written.back(), "report.html");
  for (const char* name : {"figure_3_error_norm.svg", "figure_6_slide.svg", "error_sizes.svg", "step_times.svg"}) {
    EXPECT_EQ(std::ranges::count(written, name), 1) << name;
  }
}

TEST(Summary, NamesEveryJointAndItsLag) {
  const RunRecord run = test::late_run();
  const std::string text = summary(run, evaluate(run));
  for (const char* part : {"299 of 300", "slide", "distance", "lag ", "convergence"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
}

}  // namespace
}  // namespace articam::sim
