#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/tracker/tracker.hpp"
#include "host_sim/world/object_state.hpp"
#include "host_sim/world/renderer.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/random_views.hpp"

// The printer rendered as a camera sees it (f = 525 px, blur 0.7 px, noise 4 grey levels, clutter) in random views,
// each the first frame of a tracker that was not told where to look.
namespace articam {
namespace {

struct UnstartedPrinter : models::PrinterDrawer {
  static constexpr bool kHasQ0 = false;
};

using M = UnstartedPrinter;
using Tracker = tracker::Tracker<M, double>;

constexpr CameraParameters kCamera{
    .width_px = 640, .height_px = 480, .fx_px = 525, .fy_px = 525, .cx_px = 319.5, .cy_px = 239.5};

/// 60 views, or as many as the variable says; tools/acquisition.sh asks for 2,000.
int num_views() {
  const char* text = std::getenv("ARTICAM_VIEWS");
  return text != nullptr ? std::stoi(text) : 60;
}

/// No match farther than 3 px from its own marker's true image.
bool assigned_rightly(const Tracker& tracker, const model::Configuration<M, double>& q) {
  const auto truth = tracker::predict_features<M, double>(q, tracker.camera());
  for (std::size_t m = 0; m < truth.size(); ++m) {
    const auto& match = tracker.matches()[m];
    if (match.matched && (match.pixel - truth[m].pixel).norm() > 3) return false;
  }
  return true;
}

/// Every degree of freedom within three of its own deviations.
bool inside_3_sigma(const Tracker::EstimateType& estimate, const model::Configuration<M, double>& q) {
  const auto error = model::difference(estimate.q, q);
  for (int i = 0; i < model::kDof<M>; ++i) {
    if (!(error[i] * error[i] < 9 * estimate.covariance(i, i))) return false;
  }
  return true;
}

TEST(AcquisitionOfRenderedViews, IsSureAndRightInAtLeast995Of1000AndNeverSureAndWrong) {
  const int views = num_views();
  const vision::CameraModel<double> camera{kCamera};
  test::Random random{2};
  sim::Renderer renderer{kCamera, {}};
  std::vector<std::uint8_t> pixels;
  int right = 0, wrong = 0, ambiguous = 0, unseen = 0;
  for (int i = 0; i < views; ++i) {
    const auto q = test::random_view<M>(camera, {}, random);
    renderer.render(sim::scene_markers<M>(q), static_cast<std::uint64_t>(i), pixels);
    const auto tracker = std::make_unique<Tracker>(kCamera);
    const auto estimate =
        tracker->step({pixels.data(), kCamera.width_px, kCamera.height_px, kCamera.width_px}, from_seconds(1));
    const bool found = estimate.status == tracker::TrackingStatus::tracking;
    const bool true_one = found && assigned_rightly(*tracker, q) && inside_3_sigma(estimate, q);
    const bool good = true_one && estimate.matched == model::kNumMarkers<M>;
    const int missing = 6 - static_cast<int>(tracker->detections().size());
    right += good ? 1 : 0;
    wrong += found && !true_one ? 1 : 0;
    ambiguous += estimate.reason == tracker::Reason::ambiguous ? 1 : 0;
    unseen += !good && missing > 0 ? 1 : 0;
    if (good) continue;
    std::cout << "view " << i << ": " << name(estimate.status) << ", " << name(estimate.reason) << ", "
              << tracker->detections().size() << " marks, " << estimate.matched << " matched, rms " << estimate.rms_px
              << " px, depth " << q.T_cam_obj.t.z() << " m, joints " << q.joints.transpose() << '\n';
  }
  std::cout << right << " right, " << wrong << " wrong, " << ambiguous << " ambiguous of " << views << "; in " << unseen
            << " the detector missed a marker\n";
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(right, views - views / 200 - 1);  // 99.5 %, and one: the short run has few views
}

}  // namespace
}  // namespace articam
