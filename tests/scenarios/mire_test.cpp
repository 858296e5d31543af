/// @file  Real frames: a hand-moved plate with four light dots, from Debian's visp-images-data.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "hal/firmware.hpp"
#include "hal/replay/pgm_camera.hpp"
#include "tools/modelgen/read_camera.hpp"

namespace articam {
namespace {

const std::filesystem::path kFrames = "/usr/share/visp-images-data/ViSP-images/mire-2";
constexpr std::size_t kNumFrames = 250;

/// Follows the dots with nothing of ours: a fixed threshold in a window around each dot's last place, the connected
/// component there, its centre of mass. Who is who follows from continuity alone.
class IndependentDots {
 public:
  std::array<cv::Point2d, 4> find(const hal::GreyImage& image) {
    const cv::Mat frame(image.height_px, image.width_px, CV_8UC1, const_cast<std::uint8_t*>(image.pixels.data()));
    for (auto& place : places_) place = centre_of_blob(frame, place);
    return places_;
  }

 private:
  static cv::Point2d centre_of_blob(const cv::Mat& frame, cv::Point2d last) {
    const int reach = 40;  // between frames 200 and 201 the recording jumps by 16 px
    const cv::Rect window = cv::Rect(cvRound(last.x) - reach, cvRound(last.y) - reach, 2 * reach + 1, 2 * reach + 1) &
                            cv::Rect(0, 0, frame.cols, frame.rows);
    cv::Mat binary, labels, stats, centres;
    cv::threshold(frame(window), binary, 170, 255, cv::THRESH_BINARY);  // the dots are near white, the plate near black
    const int n = cv::connectedComponentsWithStats(binary, labels, stats, centres);
    cv::Point2d best = last;
    double nearest = 1e9;
    for (int i = 1; i < n; ++i) {
      if (const int area = stats.at<int>(i, cv::CC_STAT_AREA); area < 40 || area > 450) continue;
      const cv::Point2d centre{centres.at<double>(i, 0) + window.x, centres.at<double>(i, 1) + window.y};
      const double distance = cv::norm(centre - last);
      if (distance < nearest) nearest = distance, best = centre;
    }
    return best;
  }

  std::array<cv::Point2d, 4> places_{{{93, 265}, {242, 248}, {215, 166}, {85, 178}}};  // read off the first frame
};

struct Replayed {
  int tracked_of_first_200{}, tracked_of_last_50{};
  double median_rms_px{};
  double worst_distance_px{};  ///< prediction to independent detection, over all dots and frames
  double median_joint{};
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// The recording; empty where it is not installed, or not all of it.
std::vector<std::filesystem::path> recording() {
  auto files = hal::find_frames(kFrames.string());
  files.resize(files.size() < kNumFrames ? 0 : kNumFrames);
  return files;
}

template <class Model>
void replay(const std::vector<std::filesystem::path>& files, Replayed& result) {
  modelgen::Diagnostics diagnostics;
  const auto camera_file = modelgen::read_camera(ARTICAM_CAMERAS "/mire_384x288.yaml", diagnostics);
  ASSERT_TRUE(camera_file) << diagnostics.text();
  tracker::Tracker<Model, double> tracker{*camera_file};
  hal::PgmCamera camera{files, 30};
  IndependentDots independent;
  std::vector<double> rms_px, joint;
  for (std::size_t k = 0; k < files.size(); ++k) {
    hal::Frame frame;
    ASSERT_EQ(camera.acquire(frame, {}), Status::ok) << camera.problem();
    const auto estimate = tracker.step(frame.pixels, frame.t_exposure);
    const bool tracked = estimate.status == tracker::TrackingStatus::tracking;
    (k < 200 ? result.tracked_of_first_200 : result.tracked_of_last_50) += tracked ? 1 : 0;
    const auto dots = independent.find(camera.image());
    const auto features = tracker::predict_features<Model, double>(estimate.q, tracker.camera());
    for (std::size_t i = 0; i < 4 && tracked; ++i) {
      const double distance = (features[i].pixel - Vec<double, 2>{dots[i].x, dots[i].y}).norm();
      result.worst_distance_px = std::max(result.worst_distance_px, distance);
    }
    rms_px.push_back(estimate.rms_px);
    if constexpr (model::kNumJoints < Model >> 0) joint.push_back(estimate.q.joints[0]);
  }
  result.median_rms_px = median(rms_px);
  if (!joint.empty()) result.median_joint = median(joint);
}

/// What holds whatever the model: a frame that is not tracked has no distance, so that all but one of them must be.
void expect_tracked(const Replayed& result) {
  EXPECT_EQ(result.tracked_of_first_200, 200);
  // After frame 200 the recording jumps by 16 px: what has moved at once is not taken for certain at once.
  EXPECT_GE(result.tracked_of_last_50, 47);
  // The dots are 100 px apart: no frame within this bound can have two of them swapped.
  EXPECT_LE(result.worst_distance_px, 1.5);
}

constexpr const char* kMissing = "needs the 250 frames of the package visp-images-data";

TEST(Mire, IsTrackedOnRealFramesWithEveryDotWhereAnIndependentMethodFindsIt) {
  const auto files = recording();
  if (files.empty()) GTEST_SKIP() << kMissing;
  Replayed result;
  ASSERT_NO_FATAL_FAILURE(replay<models::Mire>(files, result));
  expect_tracked(result);
  EXPECT_LE(result.median_rms_px, 0.5);
  RecordProperty("worst_distance_px", std::to_string(result.worst_distance_px));
}

/// The plate without its compiled-in start. After half a turn its four equal dots look the same.
struct UnstartedMire : models::Mire {
  static constexpr bool kHasQ0 = false;
};

/// The farthest that a dot of q is from where it is seen, the dots renamed by `half_turn`.
double farthest_px(const tracker::Tracker<UnstartedMire, double>& tracker,
                   const model::Configuration<UnstartedMire, double>& q, const std::array<cv::Point2d, 4>& dots,
                   bool half_turn) {
  const auto features = tracker::predict_features<UnstartedMire, double>(q, tracker.camera());
  double farthest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& dot = dots[half_turn ? (i + 2) % 4 : i];
    farthest = std::max(farthest, (features[i].pixel - Vec<double, 2>{dot.x, dot.y}).norm());
  }
  return farthest;
}

TEST(Mire, WithoutAStartIsAmbiguousOnRealFramesAndItsCandidatesAreBothHalfTurns) {
  const auto files = recording();
  if (files.empty()) GTEST_SKIP() << kMissing;
  modelgen::Diagnostics diagnostics;
  const auto camera_file = modelgen::read_camera(ARTICAM_CAMERAS "/mire_384x288.yaml", diagnostics);
  ASSERT_TRUE(camera_file) << diagnostics.text();
  hal::PgmCamera camera{files, 30};
  IndependentDots independent;
  int ambiguous = 0;
  for (std::size_t k = 0; k < files.size(); ++k) {
    hal::Frame frame;
    ASSERT_EQ(camera.acquire(frame, {}), Status::ok) << camera.problem();
    const auto dots = independent.find(camera.image());
    tracker::Tracker<UnstartedMire, double> tracker{*camera_file};  // each frame is the first one
    const auto estimate = tracker.step(frame.pixels, frame.t_exposure);
    ASSERT_EQ(estimate.status, tracker::TrackingStatus::initialising) << "frame " << k;
    if (estimate.reason != tracker::Reason::ambiguous) continue;
    ++ambiguous;
    const auto& found = tracker.candidates();
    ASSERT_EQ(found.size(), 2u) << "frame " << k;
    const bool turned = farthest_px(tracker, found[0].q, dots, true) < farthest_px(tracker, found[0].q, dots, false);
    EXPECT_LT(farthest_px(tracker, found[0].q, dots, turned), 1.5) << "frame " << k;
    EXPECT_LT(farthest_px(tracker, found[1].q, dots, !turned), 1.5) << "frame " << k;
  }
  // A blurred frame's dots are too large for the plate, and no pose explains them.
  EXPECT_GE(ambiguous, 230);
}

TEST(MireDistance, IdentifiesTheSpacingOfTwoDotsByAVirtualJoint) {
  const auto files = recording();
  if (files.empty()) GTEST_SKIP() << kMissing;
  Replayed result;
  ASSERT_NO_FATAL_FAILURE(replay<models::MireDistance>(files, result));
  expect_tracked(result);
  EXPECT_NEAR(result.median_joint, 0.14, 0.02 * 0.14);
}

}  // namespace
}  // namespace articam
