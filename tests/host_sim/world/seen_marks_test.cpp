#include "host_sim/world/seen_marks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/tracker/features.hpp"
#include "core/vision/detector.hpp"
#include "host_sim/scenarios/paper.hpp"

namespace articam::sim {
namespace {

using Model = PaperScenario::Model;
const vision::CameraModel<double> kCamera{PaperScenario::camera()};

TEST(SeenMarks, AreThoseThatThePredictionExpects) {
  const auto q = PaperScenario::at(7).q;
  Dice dice{1};
  vision::Detections seen;
  see_marks(scene_markers<Model>(q), {}, kCamera, 0, dice, seen);
  ASSERT_EQ(seen.size(), Model::kMarkers.size());
  const auto features = tracker::predict_features<Model, double>(q, kCamera);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    // What the pixel grid leaves without noise: six times 0.001 px.
    EXPECT_NEAR(vision::from_q16(seen[i].outer.u_q16), features[i].pixel.x(), 0.006);
    EXPECT_NEAR(vision::from_q16(seen[i].outer.v_q16), features[i].pixel.y(), 0.006);
    EXPECT_EQ(seen[i].kind, features[i].kind);
  }
}

TEST(SeenMarks, AreNotThoseOfWhichALimbHidesMoreThanATenth) {
  const auto markers = scene_markers<Model>(PaperScenario::at(0).q);
  const Vec<double, 3> before = 0.8 * markers[2].centre_cam_m;
  Dice dice{1};
  vision::Detections seen;
  const auto seen_with = [&](double off_m) {
    const Limb limb{before + Vec<double, 3>{off_m, -0.03, 0}, before + Vec<double, 3>{off_m, 0.03, 0}, 0.01};
    see_marks(markers, {&limb, 1}, kCamera, 0, dice, seen);
    return seen.size();
  };
  EXPECT_EQ(seen_with(0.05), markers.size()) << "beside it";
  EXPECT_EQ(seen_with(0.0), markers.size() - 1);
}

TEST(SeenMarks, AreWhereTheirOwnRowShowsThem) {
  CameraParameters rolling = PaperScenario::camera();
  rolling.readout_time_s = 0.02;
  auto markers = scene_markers<Model>(PaperScenario::at(0).q);
  for (SceneMarker& marker : markers) marker.velocity = {0.2, 0, 0};
  Dice dice{1};
  vision::Detections global, seen;
  see_marks(markers, {}, kCamera, 0, dice, global);
  see_marks(markers, {}, vision::CameraModel<double>{rolling}, 0, dice, seen);
  ASSERT_EQ(seen.size(), global.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double delay_s = 0.02 * vision::from_q16(global[i].outer.v_q16) / 479;
    const double way_px = vision::from_q16(seen[i].outer.u_q16 - global[i].outer.u_q16);
    // The grid's noise of both, and the perspective of a tilted mark.
    EXPECT_NEAR(way_px, 525 / markers[i].centre_cam_m.z() * 0.2 * delay_s, 0.03);
  }
}

/// Variance of the centres about the truth, and what is said of it, over frames that `see` fills.
template <class See>
std::array<double, 2> centre_variances(const model::Configuration<Model, double>& q, const See& see) {
  const auto features = tracker::predict_features<Model, double>(q, kCamera);
  vision::Detections seen;
  double had = 0, said = 0;
  int count = 0;
  for (int k = 0; k < 30; ++k) {
    see(k, seen);
    for (const vision::Detection& mark : seen) {
      for (const auto& feature : features) {
        const Vec<double, 2> off{vision::from_q16(mark.outer.u_q16) - feature.pixel.x(),
                                 vision::from_q16(mark.outer.v_q16) - feature.pixel.y()};
        if (off.norm() > 2) continue;
        had += 0.5 * off.squaredNorm();
        said += mark.centre_variance_q24 / 16777216.0;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 100);
  return {had / count, said / count};
}

TEST(SeenMarks, AreAsNoisyAsDetectionsInImagesAndSaySo) {
  for (const double depth : {0.6, 1.0, 1.8}) {
    auto q = PaperScenario::at(0).q;
    q.T_cam_obj.t *= depth;
    const auto detector = std::make_unique<vision::Detector>();
    Renderer renderer{PaperScenario::camera(), {}};
    std::vector<std::uint8_t> pixels;
    const auto in_images = centre_variances(q, [&](int k, vision::Detections& seen) {
      renderer.render(scene_markers<Model>(q), static_cast<std::uint64_t>(k), pixels);
      ASSERT_EQ(detector->detect({pixels.data(), 640, 480, 640}, seen), Status::ok);
    });
    Dice dice{2};
    const auto in_features = centre_variances(q, [&](int, vision::Detections& seen) {
      see_marks(scene_markers<Model>(q), {}, kCamera, RenderOptions{}.noise_grey, dice, seen);
    });
    for (std::size_t i = 0; i < 2; ++i) {  // had, said; the formula is a fit to some sizes of some frames
      EXPECT_GT(in_features[i], 0.5 * in_images[i]) << depth;
      EXPECT_LT(in_features[i], 2 * in_images[i]) << depth;
    }
  }
}

TEST(Normal, HasUnitVariance) {
  Dice dice{3};
  double sum = 0, squares = 0;
  constexpr int kMany = 100000;
  for (int i = 0; i < kMany; ++i) {
    const double x = normal(dice);
    sum += x, squares += x * x;
  }
  EXPECT_NEAR(sum / kMany, 0, 0.015);  // 4 sigma of the mean
  EXPECT_NEAR(squares / kMany, 1, 0.02);
}

}  // namespace
}  // namespace articam::sim
