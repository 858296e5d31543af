#include "host_sim/world/motion_blur.hpp"

#include <algorithm>
#include <cmath>

namespace articam::sim {
namespace {

constexpr int kWeightBits = 14;
constexpr int kPointsPerPixel = 16;

}  // namespace

MotionBlur::MotionBlur(const Vec<double, 2>& motion_px) {
  const double length_px = motion_px.cwiseAbs().maxCoeff();
  reach_px_ = static_cast<int>(std::ceil(length_px / 2));
  const int side = 2 * reach_px_ + 1, points = std::max(1, static_cast<int>(std::ceil(length_px * kPointsPerPixel)));
  std::vector<double> share(static_cast<std::size_t>(side * (side + 1) + 2));  // a row more, for shares of nothing
  const auto at = [&](int du, int dv) -> double& {
    return share[static_cast<std::size_t>((dv + reach_px_) * side + du + reach_px_)];
  };
  for (int i = 0; i < points; ++i) {
    const Vec<double, 2> p = ((i + 0.5) / points - 0.5) * motion_px;
    const int u = static_cast<int>(std::floor(p.x())), v = static_cast<int>(std::floor(p.y()));
    const double fu = p.x() - u, fv = p.y() - v;
    at(u, v) += (1 - fu) * (1 - fv), at(u + 1, v) += fu * (1 - fv);
    at(u, v + 1) += (1 - fu) * fv, at(u + 1, v + 1) += fu * fv;
  }
  int rest = 1 << kWeightBits;  // rounding must not change a flat area
  for (int dv = -reach_px_; dv <= reach_px_; ++dv) {
    for (int du = -reach_px_; du <= reach_px_; ++du) {
      const int weight = static_cast<int>(at(du, dv) / points * (1 << kWeightBits) + 0.5);
      if (weight == 0 || (du == 0 && dv == 0)) continue;
      taps_.push_back({du, dv, weight});
      rest -= weight;
    }
  }
  taps_.push_back({0, 0, rest});
}

void MotionBlur::apply(const GreyPlane& sharp, const PixelBox& box, GreyPlane& moved) const {
  for (int v = box.v_min_px; v <= box.v_max_px; ++v) {
    for (int u = box.u_min_px; u <= box.u_max_px; ++u) {
      int sum = 1 << (kWeightBits - 1);
      for (const Tap& tap : taps_) {
        const std::int16_t* row = sharp.row(std::clamp(v + tap.dv_px, 0, sharp.height_px - 1));
        sum += tap.weight_q14 * row[std::clamp(u + tap.du_px, 0, sharp.width_px - 1)];
      }
      moved.row(v)[u] = static_cast<std::int16_t>(sum >> kWeightBits);
    }
  }
}

}  // namespace articam::sim
