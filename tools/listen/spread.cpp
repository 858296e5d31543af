#include "tools/listen/spread.hpp"

#include <algorithm>
#include <cmath>

namespace articam::listen {
namespace {

constexpr double kLeast_s = 100e-9;
constexpr double kWidth = 1.01;

}  // namespace

void Spread::take(double t_s) {
  t_s = std::max(t_s, 0.0);
  const double i = std::floor(std::log(std::max(t_s, kLeast_s) / kLeast_s) / std::log(kWidth));
  ++classes_[static_cast<std::size_t>(std::clamp(i, 0.0, double{kClasses - 1}))];
  min_s_ = size_ == 0 ? t_s : std::min(min_s_, t_s);
  max_s_ = std::max(max_s_, t_s);
  ++size_;
}

double Spread::quantile(double share) const {
  if (size_ == 0) return 0;
  const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(size_ - 1) + 0.5);  // nearest rank
  std::uint64_t below = 0;
  std::size_t i = 0;
  while (below + classes_[i] <= wanted) below += classes_[i++];
  const double middle_s = kLeast_s * std::pow(kWidth, static_cast<double>(i) + 0.5);
  return std::clamp(middle_s, min_s_, max_s_);
}

}  // namespace articam::listen
