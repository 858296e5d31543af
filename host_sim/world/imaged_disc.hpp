#pragma once
/// @file  How much of a pixel the image of a flat disc covers.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/types.hpp"

namespace articam::sim {

/// The rays (x, y, 1) through the four corners of a pixel: upper left, upper right, lower left, lower right.
using CornerRays = std::array<Vec<double, 3>, 4>;

/// A disc in {cam}, seen as the cone of rays r with r^T Q r < 0.
///
/// The ray r meets the disc's plane n.X = n.c at X = r (n.c) / (n.r); with M = (n.c) I - c n^T the condition
/// |X - c| < R is  |M r|^2 - R^2 (n.r)^2 < 0. Exact under perspective.
/// Frames  {cam}. Units  m. The whole disc must lie at Z > 0, or the cone meets Z = 1 in more than an ellipse.
class ImagedDisc {
 public:
  ImagedDisc(const Vec<double, 3>& centre, const Vec<double, 3>& normal, double radius_m) noexcept {
    Mat<double, 3, 3> M = -centre * normal.transpose();
    M.diagonal().array() += normal.dot(centre);
    Q_ = M.transpose() * M - radius_m * radius_m * (normal * normal.transpose());
  }

  /// Negative inside, positive outside, zero on the edge.
  double side(const Vec<double, 3>& ray) const noexcept { return ray.dot(Q_ * ray); }

  /// How far side() may bend away from the straight line between the corners of a pixel, of rays `step` apart:
  /// a pixel whose corners all lie further out than this on one side is not crossed by the edge.
  double bend(double step) const noexcept {
    return 0.5 * step * step * (std::abs(Q_(0, 0)) + 2 * std::abs(Q_(0, 1)) + std::abs(Q_(1, 1)));
  }

  /// Share of the pixel inside, 0 to 1: the mean over kLines lines across the edge, on each of which the two crossings
  /// are solved exactly. A straight edge errs by at most 1 / (8 kLines^2) = 0.002, where it cuts a corner off.
  double coverage(const CornerRays& corner) const noexcept {
    const Vec<double, 3> along_u = corner[1] - corner[0] + corner[3] - corner[2];
    const Vec<double, 3> along_v = corner[2] - corner[0] + corner[3] - corner[1];
    const Vec<double, 3> slope = Q_ * (corner[0] + corner[1] + corner[2] + corner[3]);
    const bool rows = std::abs(slope.dot(along_u)) >= std::abs(slope.dot(along_v));
    const Vec<double, 3>& second = rows ? corner[1] : corner[2];
    const Vec<double, 3>& third = rows ? corner[2] : corner[1];
    double sum = 0;
    for (int i = 0; i < kLines; ++i) {
      const double t = (i + 0.5) / kLines;
      sum += length_inside(corner[0] + t * (third - corner[0]), second + t * (corner[3] - second));
    }
    return sum / kLines;
  }

 private:
  static constexpr int kLines = 8;

  /// Part of the way from ray `start` to ray `end` inside, 0 to 1: a x^2 + 2 b x + c < 0.
  double length_inside(const Vec<double, 3>& start, const Vec<double, 3>& end) const noexcept {
    const Vec<double, 3> way = end - start;
    const Vec<double, 3> Q_way = Q_ * way;
    const double a = way.dot(Q_way), b = start.dot(Q_way), c = side(start);
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0 && a > 0)) return 0;  // an ellipse is open to neither side, so a > 0; also catches NaN
    const double root = std::sqrt(discriminant);
    const double enter = std::max((-b - root) / a, 0.0), leave = std::min((-b + root) / a, 1.0);
    return std::max(leave - enter, 0.0);
  }

  Mat<double, 3, 3> Q_;
};

}  // namespace articam::sim
