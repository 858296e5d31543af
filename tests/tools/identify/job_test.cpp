#include "tools/identify/job.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "static_models/mire/mire.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/tools/identify/static_sources.hpp"
#include "tests/tools/identify/synthetic_recording.hpp"

namespace articam::identify {
namespace {

namespace fs = std::filesystem;
using models::PrinterDrawer;

class IdentifyJob : public testing::Test {
 protected:
  IdentifyJob() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    options_.urdf = test::static_path("printer_drawer", ".urdf");
    options_.markers = test::static_path("printer_drawer", ".markers.yaml");
    options_.camera_file = "front.yaml";
  }
  ~IdentifyJob() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  modelgen::SourceFile read(const char* name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name).rdbuf();
    return {name, text.str()};
  }
  /// What went wrong with a recording of the printer, or nothing; text_ is what was said.
  std::string finish(int num_moments = 80) {
    modelgen::Diagnostics diagnostics;
    const auto job = Job::prepare(options_, Object::of<PrinterDrawer>(), diagnostics);
    EXPECT_TRUE(job) << diagnostics.text();
    test::Random random{9};
    const auto recording = test::record(test::World<PrinterDrawer>{}, {{1, 0.12}}, num_moments, random);
    return job ? job->finish(recording, cameras::kXtionVga, text_) : "not prepared";
  }
  std::ptrdiff_t num_files() const { return std::distance(fs::directory_iterator(folder_), {}); }

  const fs::path folder_ = test::own_folder();
  JobOptions options_;
  std::string text_;
};

TEST_F(IdentifyJob, WritesFilesThatModelgenCompiles) {
  options_.outputs = {path("a.urdf"), path("a.yaml")};
  options_.still = {"marker_distance"};
  ASSERT_EQ(finish(), "");
  const auto table = test::compile(read("a.urdf"), read("a.yaml")).table;
  ASSERT_EQ(table.joints.size(), 1u);
  EXPECT_EQ(table.joints[0].name, "drawer_slide");
  EXPECT_EQ(table.q0.size(), 8u) << "the start has lost the number of the joint that is fixed now";
  // The markers of the truth are where the model has them, the last one at the distance.
  EXPECT_LT((table.markers[5].t_body_m - Vec3(0.06, 0.1, 0)).norm(), 0.2e-3);
  EXPECT_NE(text_.find("marker_distance"), std::string::npos) << text_;
  EXPECT_NE(text_.find("a.urdf"), std::string::npos) << text_;
}

TEST_F(IdentifyJob, WritesTheStartWithTheIdentifiedValueWhereTheJointStays) {
  options_.outputs = {path("a.yaml")};
  options_.still = {"marker_distance"};
  ASSERT_EQ(finish(), "");
  const auto table = test::compile(test::static_source("printer_drawer", ".urdf"), read("a.yaml")).table;
  ASSERT_EQ(table.q0.size(), 9u);
  EXPECT_NEAR(table.q0[8], 0.12, 0.2e-3);
}

TEST_F(IdentifyJob, TellsTheStartThatFitsAFrozenModel) {
  options_.outputs = {path("a.urdf")};
  options_.still = {"marker_distance"};
  ASSERT_EQ(finish(), "");
  EXPECT_NE(text_.find("q0: [0, 0.1, 0.6, 1, 0, 0, 0, 0]"), std::string::npos) << text_;
}

TEST_F(IdentifyJob, WritesNothingWhereThereIsNothingToTell) {
  options_.outputs = {path("a.urdf"), path("a.yaml")};
  EXPECT_NE(finish(4).find("only 4 frames"), std::string::npos);
  options_.outputs = {path("a.urdf"), path("no/such/folder.yaml")};
  options_.still = {"marker_distance"};
  EXPECT_NE(finish().find("no/such/folder.yaml"), std::string::npos);
  EXPECT_EQ(num_files(), 0);
}

TEST_F(IdentifyJob, RefusesSourcesOfAnotherModel) {
  options_.urdf = test::static_path("mire_distance", ".urdf");
  options_.markers = test::static_path("mire_distance", ".markers.yaml");
  modelgen::Diagnostics diagnostics;
  EXPECT_FALSE(Job::prepare(options_, Object::of<models::Mire>(), diagnostics));
  EXPECT_NE(diagnostics.text().find("'dot_distance' is not as in the model"), std::string::npos) << diagnostics.text();
  options_.urdf = "none.urdf";
  EXPECT_FALSE(Job::prepare(options_, Object::of<PrinterDrawer>(), diagnostics));
}

TEST_F(IdentifyJob, SaysWhatIsWrongWithTheUsage) {
  const Object object = Object::of<PrinterDrawer>();
  options_.outputs = {"a.urdf", "a.yml"};
  EXPECT_EQ(why_wrong(options_, object), "");
  options_.still = {"drawer"};
  EXPECT_NE(why_wrong(options_, object).find("drawer_slide, marker_distance"), std::string::npos);
  options_.outputs = {"a.txt"};
  EXPECT_NE(why_wrong(options_, object).find("a.txt"), std::string::npos);
}

}  // namespace
}  // namespace articam::identify
