#include "host_sim/world/gaussian_noise.hpp"

#include <algorithm>

#include "core/math/trigonometry.hpp"
#include "host_sim/world/hash.hpp"

namespace articam::sim {
namespace {

constexpr double kInverseSqrtTwoPi = 0.39894228040143267794;

double normal_density(double z) { return kInverseSqrtTwoPi * math::exp(-0.5 * z * z); }

/// P(0 < x < z) of the normal law.
/// Source  Marsaglia, "Evaluating the normal distribution", J. Stat. Software 11(4), 2004: the series of all
///         positive terms z^(2k+1) / (1 3 5 ... (2k+1)); 60 terms reach the last bit for z < 4.
double normal_area(double z) {
  double term = z, sum = z;
  for (int k = 1; k < 60; ++k) {
    term *= z * z / (2 * k + 1);
    sum += term;
  }
  return normal_density(z) * sum;
}

}  // namespace

GaussianNoise::GaussianNoise(double sigma_grey, std::uint64_t seed) : seed_{hash(seed)} {
  double z = 0;
  for (std::size_t i = 0; i < kQuantiles / 2; ++i) {
    const double area = (static_cast<double>(i) + 0.5) / kQuantiles;
    for (int k = 0; k < 6; ++k) z += (area - normal_area(z)) / normal_density(z);  // Newton from the last quantile
    const auto noise = static_cast<std::int16_t>(grey_q6(sigma_grey * z));
    noise_q6_[kQuantiles / 2 + i] = noise;
    noise_q6_[kQuantiles / 2 - 1 - i] = static_cast<std::int16_t>(-noise);
  }
}

void GaussianNoise::digitise(const GreyPlane& clean, std::uint64_t frame_index,
                             std::vector<std::uint8_t>& pixels) const {
  constexpr std::size_t kPixelsPerHash = 4;  // 16 bits each, of which a quantile takes 12
  const std::size_t count = clean.q6.size();
  const std::uint64_t frame_key = hash(seed_ ^ hash(frame_index));
  pixels.resize(count);
  for (std::size_t first = 0; first < count; first += kPixelsPerHash) {
    std::uint64_t bits = hash(frame_key + first);
    const std::size_t end = std::min(first + kPixelsPerHash, count);
    for (std::size_t i = first; i < end; ++i, bits >>= 16U) {
      const int grey = (clean.q6[i] + noise_q6_[bits % kQuantiles] + (1 << (kGreyBits - 1))) >> kGreyBits;
      pixels[i] = static_cast<std::uint8_t>(std::clamp(grey, 0, 255));
    }
  }
}

}  // namespace articam::sim
