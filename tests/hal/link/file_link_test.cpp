#include "hal/link/file_link.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "static_models/registry.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/own_folder.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;
using Estimate = tracker::Estimate<M, double>;

class FileLink : public testing::Test {
 protected:
  FileLink() { std::filesystem::create_directories(folder_); }
  ~FileLink() override { std::filesystem::remove_all(folder_); }
  std::string text() const {
    std::stringstream all;
    all << std::ifstream{path_}.rdbuf();
    return all.str();
  }
  std::filesystem::path folder_ = test::own_folder();
  std::string path_ = (folder_ / "estimates.csv").string();
};

TEST_F(FileLink, WritesTheColumnsThatUsersReadAndNumbersThatReadBackTheSame) {
  Estimate estimate;
  estimate.frame = 3;
  estimate.t_capture = from_seconds(0.1);
  estimate.status = tracker::TrackingStatus::tracking;
  estimate.valid = true;
  estimate.q = test::nominal_printer<M, double>();
  estimate.covariance.setIdentity();
  estimate.matched = 6;
  estimate.rms_px = 0.1 + 0.2;
  {
    hal::FileLink<Estimate> link;
    ASSERT_EQ(link.open(path_), Status::ok);
    ASSERT_EQ(link.publish(estimate), Status::ok);
    ASSERT_EQ(link.close(), Status::ok);
  }
  const auto& R = estimate.q.T_cam_obj.R;
  char row[512];
  std::snprintf(row, sizeof row,
                "3,0.1,tracking,none,0.02,0.08,0.7,%.17g,%.17g,%.17g,%.17g,0.08,0.12,1,1,1,1,1,1,1,1,6,%.17g", R.w(),
                R.x(), R.y(), R.z(), estimate.rms_px);
  std::istringstream lines{text()};
  std::string header, line, more;
  std::getline(lines, header), std::getline(lines, line);
  EXPECT_EQ(header,
            "frame,t_s,status,reason,px,py,pz,qw,qx,qy,qz,drawer_slide,marker_distance,"
            "std_px,std_py,std_pz,std_rx,std_ry,std_rz,std_drawer_slide,std_marker_distance,matched,rms_px");
  EXPECT_FALSE(std::getline(lines, more));
  std::istringstream ours{line}, expected{row};
  for (std::string a, b; std::getline(expected, b, ',');) {
    ASSERT_TRUE(std::getline(ours, a, ','));
    char* end = nullptr;
    const double value = std::strtod(b.c_str(), &end);
    if (*end == '\0')
      EXPECT_EQ(std::strtod(a.c_str(), nullptr), value) << b;
    else
      EXPECT_EQ(a, b);
  }
}

TEST_F(FileLink, LeavesTheFieldsOfAnEstimateThatIsNoneEmpty) {
  Estimate estimate;
  estimate.status = tracker::TrackingStatus::lost;
  estimate.reason = tracker::Reason::few_markers;
  hal::CsvLine<M> line;
  hal::put_csv_row(estimate, line);
  EXPECT_EQ(line.text(), "0,0,lost,few_markers,,,,,,,,,,,,,,,,,,0,");
}

TEST_F(FileLink, LeavesNothingBehindThatWasNotClosed) {
  {
    hal::FileLink<Estimate> link;
    ASSERT_EQ(link.open(path_), Status::ok);
    ASSERT_EQ(link.publish({}), Status::ok);
    EXPECT_FALSE(std::filesystem::exists(path_));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(FileLink, SaysWhichFileCannotBeWrittenAndWhy) {
  hal::FileLink<Estimate> link;
  EXPECT_EQ(link.open((folder_ / "no_such_folder/est.csv").string()), Status::io_error);
  EXPECT_NE(link.problem().find("no_such_folder/est.csv: cannot be created: No such file"), std::string::npos);
}

}  // namespace
}  // namespace articam
