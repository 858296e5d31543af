#include "tools/listen/csv_output.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "hal/link/csv_row.hpp"
#include "hal/link/to_message.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/support/random_state.hpp"

namespace articam::listen {
namespace {

using Model = models::PrinterDrawer;
using Estimate = tracker::Estimate<Model, double>;

const hal::ToMessage<Model> kToMessage{CameraParameters{}, 1, 30};

Estimate random_estimate(test::Random& random, bool valid) {
  Estimate estimate;
  estimate.frame = static_cast<std::uint32_t>(random.uniform(0, 4e9));
  estimate.t_capture.ns = static_cast<std::int64_t>(random.uniform(0, 1e15));
  estimate.status = static_cast<tracker::TrackingStatus>(random.uniform(0, 6));
  estimate.reason = static_cast<tracker::Reason>(random.uniform(0, 14));
  estimate.valid = valid;
  estimate.matched = valid ? 5 : 0;
  estimate.rms_px = random.uniform(0, 1);
  estimate.q.T_cam_obj.t = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1)};
  estimate.q.T_cam_obj.R = Quat<double>{0.5, -0.5, 0.5, 0.5};
  for (int j = 0; j < model::kNumJoints<Model>; ++j) estimate.q.joints[j] = random.uniform(0, 1e-3);
  for (int i = 0; i < Estimate::kDof; ++i) {
    for (int k = 0; k < Estimate::kDof; ++k) estimate.covariance(i, k) = random.uniform(0, 1e-6);
  }
  return estimate;
}

TEST(CsvOutput, WritesTheBytesThatReplayWritesForTheSameEstimate) {
  test::Random random{12};
  hal::CsvLine<Model> line;
  hal::put_csv_header<Model>(line);
  EXPECT_EQ(csv_header(kToMessage.model()), line.text());
  for (int trial = 0; trial < 1000; ++trial) {
    const Estimate estimate = random_estimate(random, trial % 4 != 0);
    line.clear();
    hal::put_csv_row(estimate, line);
    constexpr auto kNumJoints = static_cast<std::size_t>(model::kNumJoints<Model>);
    ASSERT_EQ(csv_row(kToMessage.estimate(estimate), kNumJoints), line.text()) << "seed 12, trial " << trial;
  }
}

TEST(CsvOutput, CountsTimeFromTheFirstEstimateWhereAskedTo) {
  test::Random random{13};
  const auto model = kToMessage.model();
  auto estimate = kToMessage.estimate(random_estimate(random, true));
  estimate.frame = 4, estimate.t_capture.ns = 5'250'000'000;
  const auto path = test::own_folder();
  auto file = std::make_unique<RecordFile>();
  ASSERT_EQ(file->create(path, true), "");
  CsvOutput output{std::move(file), true};
  EXPECT_EQ(output.take({estimate, model, Timestamp{5'000'000'000}}), "");
  auto other = model;
  other.joint_names.clear();
  EXPECT_NE(output.take({estimate, other}), "") << "numbers of another object under the names of this one";
  EXPECT_EQ(output.finish(), "");
  std::ifstream stream{path};
  std::string header, row;
  std::getline(stream, header), std::getline(stream, row);
  EXPECT_EQ(header, csv_header(model));
  EXPECT_EQ(row.substr(0, 7), "4,0.25,");
  EXPECT_FALSE(std::getline(stream, row));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace articam::listen
