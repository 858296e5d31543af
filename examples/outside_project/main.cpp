// A door opens in drawn frames, and the tracker says how far: one line a frame. With a folder as argument the frames
// are kept there, for cupboard_board --camera replay:FOLDER.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include "cameras/front.hpp"
#include "core/config.hpp"
#include "core/model/forward_kinematics.hpp"
#include "core/tracker/tracker.hpp"
#include "models/cupboard.hpp"

namespace {

using articam::Pose;
using articam::Vec;
using articam::models::Cupboard;
using Tracker = articam::tracker::Tracker<Cupboard, articam::DefaultScalar>;

constexpr auto& kCamera = articam::cameras::kFront;
constexpr int kWidth = kCamera.width_px, kHeight = kCamera.height_px;
using Pixels = std::array<std::uint8_t, static_cast<std::size_t>(kWidth* kHeight)>;

/// Whether the ray through a place of the image (px) meets the disc.
bool sees(double u, double v, const Vec<double, 3>& centre, const Vec<double, 3>& normal, double radius_m) {
  const Vec<double, 3> ray{(u - kCamera.cx_px) / kCamera.fx_px, (v - kCamera.cy_px) / kCamera.fy_px, 1};
  const double along = normal.dot(centre) / normal.dot(ray);
  return (ray * along - centre).norm() < radius_m;
}

void draw_dot(const Vec<double, 3>& centre, const Vec<double, 3>& normal, double radius_m, Pixels& pixels) {
  constexpr int kParts = 4;  // of a pixel, in each direction: edges are grey, as a camera's are
  const int u0 = static_cast<int>(kCamera.cx_px + kCamera.fx_px * centre.x() / centre.z());
  const int v0 = static_cast<int>(kCamera.cy_px + kCamera.fy_px * centre.y() / centre.z());
  const int reach = static_cast<int>(2 * kCamera.fx_px * radius_m / centre.z());
  for (int v = std::max(0, v0 - reach); v < std::min(kHeight, v0 + reach); ++v) {
    for (int u = std::max(0, u0 - reach); u < std::min(kWidth, u0 + reach); ++u) {
      int dark = 0;
      for (int part = 0; part < kParts * kParts; ++part) {
        dark += sees(u + (part % kParts + 0.5) / kParts - 0.5, v + (part / kParts + 0.5) / kParts - 0.5, centre, normal,
                     radius_m);
      }
      pixels[static_cast<std::size_t>(v * kWidth + u)] -= static_cast<std::uint8_t>(160 * dark / (kParts * kParts));
    }
  }
}

void draw(const Pose<double>& T_cam_obj, double hinge_rad, Pixels& pixels) {
  pixels.fill(200);
  const auto kinematics = articam::model::forward_kinematics<Cupboard, double>(Vec<double, 1>{hinge_rad});
  for (std::size_t m = 0; m < Cupboard::kMarkers.size(); ++m) {
    const auto& place = kinematics.markers[m];
    draw_dot(T_cam_obj * place.centre, T_cam_obj.R * place.normal, Cupboard::kMarkers[m].outer_diameter_m / 2, pixels);
  }
}

void keep(const std::string& path, const Pixels& pixels) {
  std::ofstream file(path, std::ios::binary);
  file << "P5\n" << kWidth << ' ' << kHeight << "\n255\n";
  file.write(reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
}

}  // namespace

int main(int argc, char** argv) {
  const Pose<double> T_cam_obj{articam::math::exp_so3<double>({0.1, 0.2, 0}), {0.02, -0.01, 0.85}};
  const auto tracker = std::make_unique<Tracker>(kCamera);  // large: it holds the detector's images
  const auto pixels = std::make_unique<Pixels>();
  constexpr int kFrames = 60;
  double worst_rad = 0;
  std::puts("frame,hinge_rad,estimate_rad,std_rad,status");
  for (int frame = 0; frame < kFrames; ++frame) {
    const double hinge_rad = 0.4 * (1 - std::cos(3.14159265 * frame / kFrames));  // shut -> wide open, softly
    draw(T_cam_obj, hinge_rad, *pixels);
    if (argc > 1) {
      char name[16];
      std::snprintf(name, sizeof name, "/%04d.pgm", frame);
      keep(argv[1] + std::string(name), *pixels);
    }
    const auto estimate = tracker->step({pixels->data(), kWidth, kHeight, kWidth}, articam::from_seconds(frame / 30.0));
    const double found_rad = estimate.q.joints[0];
    std::printf("%d,%.5f,%.5f,%.5f,%s\n", frame, hinge_rad, found_rad, std::sqrt(estimate.covariance(6, 6)),
                std::string(name(estimate.status)).c_str());
    if (frame > kFrames / 2) worst_rad = std::max(worst_rad, std::abs(found_rad - hinge_rad));
  }
  std::fprintf(stderr, "wide open, the estimate is within %.2g rad\n", worst_rad);
  return worst_rad < 0.005 ? 0 : 1;
}
