#include "host_sim/report/line_fit.hpp"

#include <cmath>
#include <vector>

namespace articam::sim {

LineFit fit_line(std::span<const double> x, std::span<const double> y, std::size_t reach) noexcept {
  const std::size_t n = x.size();
  if (n < 3 || y.size() != n) return {};
  double x_mean = 0, y_mean = 0;
  for (std::size_t i = 0; i < n; ++i) x_mean += x[i], y_mean += y[i];
  x_mean /= static_cast<double>(n), y_mean /= static_cast<double>(n);
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  if (!(xx > 0)) return {};

  LineFit fit;
  fit.slope = xy / xx;
  fit.intercept = y_mean - fit.slope * x_mean;
  std::vector<double> score(n);
  for (std::size_t i = 0; i < n; ++i) score[i] = (x[i] - x_mean) * (y[i] - fit.intercept - fit.slope * x[i]);
  double spread = 0;
  for (std::size_t lag = 0; lag <= reach && lag < n; ++lag) {
    double sum = 0;
    for (std::size_t i = lag; i < n; ++i) sum += score[i] * score[i - lag];
    const double weight = 1 - static_cast<double>(lag) / static_cast<double>(reach + 1);
    spread += (lag == 0 ? 1 : 2) * weight * sum;
  }
  fit.slope_std = std::sqrt(spread > 0 ? spread : 0) / xx;
  return fit;
}

}  // namespace articam::sim
