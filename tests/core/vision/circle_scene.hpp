#pragma once
/// @file  Random circles before a camera, and their images from the dual conic alone.

#include <cmath>

#include "core/vision/imaged_circle.hpp"
#include "core/vision/plane_ellipse.hpp"
#include "tests/support/random_state.hpp"

namespace articam::test {

/// The image of a circle on the metric plane, from its dual conic  c c^T - r^2 (I - n n^T).
inline vision::PlaneEllipse<double> image_of(const vision::Circle<double>& circle) {
  const auto& [c, n, r] = circle;
  const Mat<double, 3, 3> dual = c * c.transpose() - r * r * (Mat<double, 3, 3>::Identity() - n * n.transpose());
  vision::PlaneEllipse<double> e;
  e.centre = dual.block<2, 1>(0, 2) / dual(2, 2);
  const Mat<double, 2, 2> shape = e.centre * e.centre.transpose() - dual.block<2, 2>(0, 0) / dual(2, 2);
  const double m00 = std::sqrt(shape(0, 0)), m10 = shape(1, 0) / m00;
  e.M << m00, 0, m10, std::sqrt(shape(1, 1) - m10 * m10);
  return e;
}

/// In view of a wide camera, facing it, 0 to 85 degrees off its ray.
inline vision::Circle<double> circle_in_view(Random& random) {
  for (;;) {
    const double z = random.uniform(0.2, 2);
    const Vec<double, 3> centre{random.uniform(-0.7, 0.7) * z, random.uniform(-0.5, 0.5) * z, z};
    const Vec<double, 3> normal = random.vector<double, 3>(-1, 1).normalized();
    if (normal.dot(centre.normalized()) < -0.087) return {centre, normal, random.uniform(0.005, 0.05)};
  }
}

}  // namespace articam::test
