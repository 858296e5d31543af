#include "host_sim/world/gaussian_blur.hpp"

#include <algorithm>

#include "core/math/trigonometry.hpp"

namespace articam::sim {
namespace {

constexpr int kWeightBits = 14;
constexpr int kHalf = 1 << (kWeightBits - 1);

}  // namespace

GaussianBlur::GaussianBlur(double sigma_px) {
  const int reach = sigma_px > 0 ? static_cast<int>(4 * sigma_px) + 1 : 0;
  std::vector<double> weights(1, 1.0);
  double sum = 1;
  for (int k = 1; k <= reach; ++k) {
    weights.push_back(math::exp(-0.5 * k * k / (sigma_px * sigma_px)));
    sum += 2 * weights.back();
  }
  int rest = 1 << kWeightBits;
  for (const double weight : weights) weights_q14_.push_back(static_cast<int>(weight / sum * (1 << kWeightBits) + 0.5));
  for (int k = 1; k <= reach; ++k) rest -= 2 * weights_q14_[static_cast<std::size_t>(k)];
  weights_q14_[0] = rest;  // rounding must not change a flat area
}

void GaussianBlur::apply(const GreyPlane& sharp, const PixelBox& box, GreyPlane& soft) {
  const int reach = reach_px();
  const int width = box.u_max_px - box.u_min_px + 1;
  const int height = box.v_max_px - box.v_min_px + 1;
  if (width <= 0 || height <= 0) return;
  rows_q6_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height + 2 * reach));

  const auto row_of = [&](int i) { return rows_q6_.data() + static_cast<std::ptrdiff_t>(i) * width; };
  for (int i = 0; i < height + 2 * reach; ++i) {
    const std::int16_t* in = sharp.row(std::clamp(box.v_min_px - reach + i, 0, sharp.height_px - 1));
    int* out = row_of(i);
    for (int j = 0; j < width; ++j) {
      const int u = box.u_min_px + j;
      int sum = kHalf + weights_q14_[0] * in[u];
      for (int k = 1; k <= reach; ++k) {
        const int left = in[std::max(u - k, 0)], right = in[std::min(u + k, sharp.width_px - 1)];
        sum += weights_q14_[static_cast<std::size_t>(k)] * (left + right);
      }
      out[j] = sum >> kWeightBits;
    }
  }
  for (int i = 0; i < height; ++i) {
    std::int16_t* out = soft.row(box.v_min_px + i) + box.u_min_px;
    for (int j = 0; j < width; ++j) {
      int sum = kHalf + weights_q14_[0] * row_of(i + reach)[j];
      for (int k = 1; k <= reach; ++k) {
        sum += weights_q14_[static_cast<std::size_t>(k)] * (row_of(i + reach - k)[j] + row_of(i + reach + k)[j]);
      }
      out[j] = static_cast<std::int16_t>(sum >> kWeightBits);
    }
  }
}

}  // namespace articam::sim
