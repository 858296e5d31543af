#include "tests/core/vision/centre_bound.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/so3.hpp"
#include "core/vision/imaged_ellipse.hpp"
#include "tests/core/vision/marker_scene.hpp"

namespace articam::test {
namespace {

using Image = Eigen::ArrayXXd;                  // rows, columns
using Outline = Eigen::Matrix<double, 5, 1>;    // an ellipse: centre u, v and m00, m10, m11, px
using Outlines = Eigen::Matrix<double, 15, 1>;  // of card, ring and hole
using Derivatives = Eigen::MatrixXd;            // grey levels of the patch by what is sought

// As the renderer has them.
constexpr double kWall = 130, kCard = 215, kMark = 30, kCardRatio = 1.4;
constexpr std::array<double, 3> kContrast{kCard - kWall, kMark - kCard, kCard - kMark};

struct Patch {
  int u_min, v_min, size;
};

Outline outline(const sim::SceneMarker& ring, double radius_m) {
  const auto e = vision::imaged_ellipse<double>({ring.centre_cam_m, ring.normal_cam, radius_m}).value();
  const double f = kVga.fx_px;
  return {f * e.centre.x() + kVga.cx_px, f * e.centre.y() + kVga.cy_px, f * e.M(0, 0), f * e.M(1, 0), f * e.M(1, 1)};
}

Outlines outlines(const sim::SceneMarker& ring) {
  return (Outlines{} << outline(ring, kCardRatio * ring.outer_radius_m), outline(ring, ring.outer_radius_m),
          outline(ring, ring.inner_radius_m))
      .finished();
}

/// Adds the part of each pixel of a row that lies inside, along one line of it, at the height v.
template <class Row>
void add_inside(const Outline& e, const Patch& patch, double v, double share, Row row) {
  // |M^-1 (x, y)| = 1, a quadratic in x:  (x / m00)^2 + ((y - m10 x / m00) / m11)^2 = 1
  const double slope = e[3] / e[2], y = v - e[1];
  const double a = 1 / (e[2] * e[2]) + slope * slope / (e[4] * e[4]), b = -y * slope / (e[4] * e[4]);
  const double discriminant = b * b - a * (y * y / (e[4] * e[4]) - 1);
  if (discriminant <= 0) return;
  const double middle = e[0] - b / a + 0.5 - patch.u_min, half = std::sqrt(discriminant) / a;
  const double enter = std::max(middle - half, 0.0), leave = std::min(middle + half, double(patch.size));
  for (int j = static_cast<int>(enter); j < leave; ++j)
    row[j] += share * (std::min(leave, j + 1.0) - std::max(enter, double(j)));
}

Image blurred(const Image& sharp, double sigma_px) {
  const int reach = static_cast<int>(4 * sigma_px) + 1;
  Eigen::ArrayXd weights(2 * reach + 1);
  for (int k = -reach; k <= reach; ++k) weights[k + reach] = std::exp(-0.5 * k * k / (sigma_px * sigma_px));
  weights /= weights.sum();
  const Eigen::Index n = sharp.cols();
  Image across = Image::Zero(n, n), out = across;
  for (int k = -reach; k <= reach; ++k)
    for (Eigen::Index j = std::max(0, -k); j < n - std::max(0, k); ++j)
      across.col(j) += weights[k + reach] * sharp.col(j + k);
  for (int k = -reach; k <= reach; ++k)
    for (Eigen::Index i = std::max(0, -k); i < n - std::max(0, k); ++i)
      out.row(i) += weights[k + reach] * across.row(i + k);
  return out;
}

/// The shares of the patch's pixels that the ellipse covers, seen through the lens.
Image cover(const Outline& e, const Patch& patch, double blur_px) {
  constexpr int kLines = 32;
  Image sharp = Image::Zero(patch.size, patch.size);
  for (int i = 0; i < patch.size; ++i)
    for (int k = 0; k < kLines; ++k)
      add_inside(e, patch, patch.v_min + i - 0.5 + (k + 0.5) / kLines, 1.0 / kLines, sharp.row(i));
  return blurred(sharp, blur_px);
}

/// How the three ellipses follow the ring's place and normal.
Eigen::Matrix<double, 15, 5> by_pose(const sim::SceneMarker& ring) {
  constexpr double kStep_m = 1e-6, kStep_rad = 1e-4;
  const Vec<double, 3> e1 = ring.normal_cam.unitOrthogonal(), e2 = ring.normal_cam.cross(e1);
  Eigen::Matrix<double, 15, 5> J;
  for (int i = 0; i < 5; ++i) {
    const auto moved = [&](double way) {
      sim::SceneMarker other = ring;
      if (i < 3)
        other.centre_cam_m[i] += way * kStep_m;
      else
        other.normal_cam = math::exp_so3<double>(way * kStep_rad * (i == 3 ? e1 : e2)) * ring.normal_cam;
      return outlines(other);
    };
    J.col(i) = moved(1) - moved(-1);
  }
  return J;
}

/// Root of the trace of the centre's covariance, where the ellipses are J x and x is sought, and what `others` are
/// derivatives of.
double bound_px(const Derivatives& by_outlines, const Derivatives& others, const Eigen::MatrixXd& J, double variance) {
  Derivatives all(others.rows(), J.cols() + others.cols());
  all << by_outlines * J, others;
  const Eigen::VectorXd scale = all.colwise().norm().cwiseInverse().transpose();  // of one size, for the inverse
  all = all * scale.asDiagonal();
  const Eigen::MatrixXd centre = J.middleRows(5, 2) * scale.head(J.cols()).asDiagonal();
  const Eigen::MatrixXd covariance = (all.transpose() * all).completeOrthogonalDecomposition().pseudoInverse();
  return std::sqrt(variance * (centre * covariance.topLeftCorner(J.cols(), J.cols()) * centre.transpose()).trace());
}

}  // namespace

CentreBound centre_bound(const sim::SceneMarker& ring, const sim::RenderOptions& options) {
  constexpr double kStep_px = 0.02;
  const Outlines seen = outlines(ring);
  const int reach = static_cast<int>(std::max(seen[2], std::hypot(seen[3], seen[4])) + 8 * options.blur_px) + 2;
  const Patch patch{static_cast<int>(seen[0]) - reach, static_cast<int>(seen[1]) - reach, 2 * reach + 1};
  const auto from = [&patch](int first) {
    return Eigen::ArrayXd::LinSpaced(patch.size, first, first + patch.size - 1);
  };
  const Image u = from(patch.u_min).transpose().replicate(patch.size, 1),
              v = from(patch.v_min).replicate(1, patch.size);
  const Image light = 1 + u / kVga.width_px * (1 / options.light_gradient - 1);
  const auto column = [](const Image& image) { return image.matrix().reshaped(); };

  Derivatives by_outlines(u.size(), 15), others(u.size(), 6);
  Image wider = Image::Zero(patch.size, patch.size), scene = Image::Constant(patch.size, patch.size, kWall);
  std::array<Image, 3> covered;
  for (int k = 0; k < 3; ++k) {
    const Outline e = seen.segment<5>(5 * k);
    Image& here = covered[static_cast<std::size_t>(k)];
    const double contrast = kContrast[static_cast<std::size_t>(k)];
    here = cover(e, patch, options.blur_px);
    scene += contrast * here;
    wider += contrast * (cover(e, patch, options.blur_px + kStep_px) - here) / kStep_px;
    for (int i = 0; i < 5; ++i) {
      const Outline step = kStep_px * Outline::Unit(i);
      const Image slope = cover(e + step, patch, options.blur_px) - cover(e - step, patch, options.blur_px);
      by_outlines.col(5 * k + i) = column(light * contrast * slope / (2 * kStep_px));
    }
  }
  others << column(light * wider), column(light * (1 - covered[0])),
      column(light * (covered[0] - covered[1] + covered[2])), column(light * (covered[1] - covered[2])),
      column(scene * (u - seen[0])), column(scene * (v - seen[1]));
  const double variance = options.noise_grey * options.noise_grey + 1.0 / 12;  // and that of rounding
  return {bound_px(by_outlines, others, by_pose(ring), variance),
          bound_px(by_outlines, others, Eigen::MatrixXd::Identity(15, 15), variance)};
}

}  // namespace articam::test
