#include "host_sim/report/truth_csv.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/host_sim/report/synthetic_run.hpp"

namespace articam::sim {
namespace {

TEST(TruthCsv, HasARowForEveryFrameAndNumbersThatReadBackAsTheyWere) {
  const RunRecord run = test::late_run();
  std::istringstream csv{truth_csv(run)};
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "frame,t_s,px,py,pz,qw,qx,qy,qz,slide,distance");
  for (const FrameRecord& frame : run.frames) {
    ASSERT_TRUE(std::getline(csv, line));
    std::istringstream fields{line};
    std::vector<double> numbers;
    for (std::string field; std::getline(fields, field, ',');) numbers.push_back(std::stod(field));
    ASSERT_EQ(numbers.size(), 11u);
    EXPECT_EQ(numbers[0], frame.frame);
    EXPECT_EQ(numbers[1], frame.t_s);
    EXPECT_EQ(numbers[4], frame.truth.T_cam_obj.t.z());
    EXPECT_EQ(numbers[9], frame.truth.joints[0]);
  }
  EXPECT_FALSE(std::getline(csv, line));
}

}  // namespace
}  // namespace articam::sim
