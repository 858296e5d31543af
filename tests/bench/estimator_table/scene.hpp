#pragma once
/// @file  The printer's marks exactly as a camera of 640 x 480 sees them, with noise of a known size, and the least
///        variance that any unbiased estimator can reach from them. Shares no formula with the estimator.

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/model/forward_kinematics.hpp"
#include "core/tracker/associate.hpp"
#include "core/vision/plane_ellipse.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "tests/support/random_state.hpp"

namespace articam::estimator_table {

using Printer = models::PrinterDrawer;

/// Its joints without limits: the bound is one of estimators that know of none, and a closed drawer stands at one.
struct FreePrinter : Printer {
  static constexpr auto kJoints = [] {
    auto rows = Printer::kJoints;
    for (model::JointRow& row : rows) row.q_min = -1, row.q_max = 1;
    return rows;
  }();
};

/// The upper two base markers set back, so that the base is no plane.
struct DeepPrinter : FreePrinter {
  static constexpr auto kMarkers = [] {
    auto rows = Printer::kMarkers;
    rows[0].t_body_m = {-0.16, -0.125, 0.25}, rows[1].t_body_m = {0.16, -0.125, 0.25};
    return rows;
  }();
};

inline constexpr int kDof = model::kDof<Printer>;
inline constexpr std::size_t kMarks = Printer::kMarkers.size(), kBaseMarks = 4;
inline constexpr double kFrame_s = 1.0 / 30, kDegree = 0.017453292519943295;
using Vec8 = Vec<double, kDof>;
using Mat8 = Mat<double, kDof, kDof>;

template <class M>
model::Configuration<M, double> configuration(double z_m, const Vec<double, 3>& yaw_pitch_roll_deg, double q1_m,
                                              double q2_m) {
  model::Configuration<M, double> q;
  const Vec<double, 3> turn = yaw_pitch_roll_deg * kDegree;
  q.T_cam_obj.t = {0.02, 0.08, z_m};
  q.T_cam_obj.R = math::exp_so3<double>({0, 0, turn[0]}) * math::exp_so3<double>({0, turn[1], 0}) *
                  math::exp_so3<double>({turn[2], 0, 0});
  q.joints = {q1_m, q2_m};
  return q;
}

/// The drawer open by 80 mm, seen from 0.7 m.
template <class M>
model::Configuration<M, double> nominal() {
  return configuration<M>(0.70, {5, -10, 30}, 0.08, 0.12);
}

/// Of a marker's outer edge: centre (u, v) and the lower triangular M of detection.hpp, px.
using Image = Vec<double, 5>;
using Images = std::array<Image, kMarks>;

/// By the dual conic  K (c c^T - r^2 (I - n n^T)) K^T;  every radius times `scale`, 0 for plain points.
template <class M>
Images images_of(const model::Configuration<M, double>& q, double scale = 1) {
  const CameraParameters camera = sim::PaperScenario::camera();
  Mat<double, 3, 3> K;
  K << camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1;
  const auto kinematics = model::forward_kinematics<M, double>(q.joints);
  Images images;
  for (std::size_t i = 0; i < kMarks; ++i) {
    const Vec<double, 3> c = q.T_cam_obj * kinematics.markers[i].centre;
    const Vec<double, 3> n = q.T_cam_obj.R * kinematics.markers[i].normal;
    const double r = scale * 0.5 * M::kMarkers[i].outer_diameter_m;
    const Mat<double, 3, 3> C =
        K * (c * c.transpose() - r * r * (Mat<double, 3, 3>::Identity() - n * n.transpose())) * K.transpose();
    const Vec<double, 2> s = C.topRightCorner<2, 1>() / C(2, 2);
    images[i] << s, 0, 0, 0;
    if (!(scale > 0)) continue;
    const Mat<double, 2, 2> shape = s * s.transpose() - C.topLeftCorner<2, 2>() / C(2, 2);
    const double m00 = std::sqrt(shape(0, 0)), m10 = shape(1, 0) / m00;
    images[i].tail<3>() << m00, m10, std::sqrt(shape(1, 1) - m10 * m10);
  }
  return images;
}

/// Deviations of what is seen, px. A shape of deviation 0 is not to be used.
struct Noise {
  double centre_px{}, shape_px{};
};

inline Images observe(Images images, const Noise& noise, test::Random& random) {
  for (Image& image : images) {
    for (int k = 0; k < 5; ++k) image[k] += (k < 2 ? noise.centre_px : noise.shape_px) * random.gaussian();
  }
  return images;
}

/// One bit for each marker that is seen.
using Mask = unsigned;
inline constexpr Mask kAll = 0x3f, kBase = 0x0f;

template <class M, class S>
tracker::Matches<M, S> matches_of(const Images& images, const Noise& noise, Mask seen = kAll) {
  const CameraParameters camera = sim::PaperScenario::camera();
  const double f = camera.fx_px;
  tracker::Matches<M, S> matches{};
  for (std::size_t i = 0; i < kMarks; ++i) {
    if ((seen >> i & 1u) == 0) continue;
    auto& match = matches[i];
    match.matched = true;
    match.pixel = images[i].template head<2>().template cast<S>();
    match.s_star = {static_cast<S>((images[i][0] - camera.cx_px) / f),
                    static_cast<S>((images[i][1] - camera.cy_px) / f)};
    match.variance = static_cast<S>(noise.centre_px * noise.centre_px / (f * f));
    match.shape = (images[i].template tail<3>() / f).template cast<S>();
    match.shape_variance = static_cast<S>(noise.shape_px * noise.shape_px / (f * f));
  }
  return matches;
}

/// In the table's order, those that are not seen left out.
inline vision::Detections detections_of(const Images& images, const Noise& noise, Mask seen = kAll) {
  const auto q24 = [](double px) { return static_cast<std::uint32_t>(px * px * (1 << 24) + 0.5); };
  vision::Detections detections;
  for (std::size_t i = 0; i < kMarks; ++i) {
    if ((seen >> i & 1u) == 0) continue;
    vision::PlaneEllipse<double> ellipse;
    ellipse.centre = images[i].head<2>();
    ellipse.M << images[i][2], 0, images[i][3], images[i][4];
    vision::Detection mark;
    mark.kind = vision::MarkKind::ring;
    mark.flaws = noise.shape_px > 0 ? 0 : vision::kBlurred;  // then only the centre is taken for true
    mark.outer = vision::to_q16(ellipse);
    mark.centre_variance_q24 = q24(noise.centre_px);
    mark.axis_variance_q24 = q24(noise.shape_px > 0 ? noise.shape_px : noise.centre_px);
    (void)detections.push_back(mark);
  }
  return detections;
}

/// Variances of every marker's centre and shape, px^2; 0: not seen.
using Variances = std::array<Vec<double, 2>, kMarks>;

inline Variances variances_of(const Noise& noise, Mask seen = kAll) {
  Variances variances;
  for (std::size_t i = 0; i < kMarks; ++i) {
    variances[i] = (seen >> i & 1u) * Vec<double, 2>{noise.centre_px, noise.shape_px}.cwiseAbs2();
  }
  return variances;
}

/// Fisher's information about the step (t, rotation, joints), 1/m^2 and 1/rad^2, by central differences. Every radius
/// is `scale` times the table's; that is known where `print_scale` is 0, otherwise to that deviation, and eliminated.
template <class M>
Mat8 information(const model::Configuration<M, double>& q, const Variances& variances, double scale = 1,
                 double print_scale = 0) {
  constexpr double kStep = 1e-6;
  std::array<Images, kDof + 1> A;
  for (std::size_t c = 0; c <= kDof; ++c) {
    const Vec8 step = c < kDof ? Vec8(kStep * Vec8::Unit(static_cast<int>(c))) : Vec8(Vec8::Zero());
    const double u = c < kDof ? 0 : kStep;
    const Images after = images_of<M>(model::integrate<M, double>(q, step), scale * std::exp(u));
    const Images before = images_of<M>(model::integrate<M, double>(q, -step), scale * std::exp(-u));
    for (std::size_t i = 0; i < kMarks; ++i) A[c][i] = (after[i] - before[i]) / (2 * kStep);
  }
  Mat<double, kDof + 1, kDof + 1> H = Mat<double, kDof + 1, kDof + 1>::Zero();
  for (std::size_t i = 0; i < kMarks; ++i) {
    Image weight = Image::Zero();
    if (variances[i][0] > 0) weight.head<2>().setConstant(1 / variances[i][0]);
    if (variances[i][1] > 0) weight.tail<3>().setConstant(1 / variances[i][1]);
    for (std::size_t r = 0; r <= kDof; ++r) {
      for (std::size_t c = 0; c <= kDof; ++c) {
        H(static_cast<int>(r), static_cast<int>(c)) += A[r][i].cwiseProduct(weight).dot(A[c][i]);
      }
    }
  }
  const Mat8 known = H.topLeftCorner<kDof, kDof>();
  if (!(print_scale > 0)) return known;
  const Vec8 with_scale = H.topRightCorner<kDof, 1>();
  return known - with_scale * with_scale.transpose() / (H(kDof, kDof) + 1 / (print_scale * print_scale));
}

/// The Cramer-Rao bound of each degree of freedom's deviation; of the base's alone where the joints are not seen.
inline Vec8 deviations(const Mat8& information) {
  Vec8 bound = Vec8::Constant(std::nan(""));
  const Eigen::SelfAdjointEigenSolver<Mat<double, 2, 2>> joints(information.bottomRightCorner<2, 2>());
  if (joints.eigenvalues()[0] > 1e-9 * information.norm()) {
    bound = information.inverse().diagonal().cwiseSqrt();
  } else {
    bound.head<6>() = information.topLeftCorner<6, 6>().inverse().diagonal().cwiseSqrt();
  }
  return bound;
}

/// Root mean square of errors, one of each degree of freedom.
class RootMeanSquare {
 public:
  void add(const Vec8& error) { sum_ += error.cwiseAbs2(), ++n_; }
  Vec8 value() const { return (sum_ / n_).cwiseSqrt(); }
  int count() const { return n_; }

 private:
  Vec8 sum_ = Vec8::Zero();
  int n_{};
};

}  // namespace articam::estimator_table
