#pragma once
/// @file  A drawer that rests, then opens and closes again and again.

namespace articam::sim {

/// A joint value and its rate: m and m/s, or rad and rad/s.
struct JointMotion {
  double position{};
  double velocity{};
};

/// Rest, then cycles of: open, dwell, close, dwell. Each stroke is the quintic 10 s^3 - 15 s^4 + 6 s^5, which starts
/// and ends without velocity or acceleration; its peak velocity is 15/8 of the mean, with these numbers 50 mm/s.
struct DrawerMotion {
  double closed_m = 0.02;
  double open_m = 0.10;
  double rest_s = 5;
  double stroke_s = 3;
  double dwell_s = 1;

  constexpr JointMotion at(double t_s) const noexcept {
    const double cycle_s = 2 * (stroke_s + dwell_s);
    double t = t_s - rest_s;
    if (t <= 0) return {closed_m, 0};
    t -= cycle_s * static_cast<double>(static_cast<long long>(t / cycle_s));
    const double half_s = 0.5 * cycle_s;
    return t < half_s ? stroke(closed_m, open_m, t) : stroke(open_m, closed_m, t - half_s);
  }

 private:
  constexpr JointMotion stroke(double from_m, double to_m, double t_s) const noexcept {
    if (t_s >= stroke_s) return {to_m, 0};
    const double s = t_s / stroke_s, way_m = to_m - from_m;
    return {from_m + way_m * s * s * s * (10 + s * (6 * s - 15)), way_m / stroke_s * 30 * s * s * (1 - s) * (1 - s)};
  }
};

}  // namespace articam::sim
