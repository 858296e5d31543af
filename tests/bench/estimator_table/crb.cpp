/// @file  One frame, centres only: is each degree of freedom as good as the noise allows?

#include <algorithm>

#include "core/tracker/vvs.hpp"
#include "tests/bench/estimator_table/scene.hpp"
#include "tests/bench/estimator_table/table.hpp"

namespace articam::estimator_table {
namespace {

/// Bounds computed elsewhere, of projected points at 0.3 px: x y z (mm), roll pitch yaw (deg), q1 q2 (mm).
using Published = std::array<double, kDof>;

/// Turns the rotation vector's part of a covariance into that of the angles of R = Rz(yaw) Ry(pitch) Rx(roll).
Vec8 in_published_units(const Mat8& covariance, const Quat<double>& R) {
  const auto angles = [&](const Vec<double, 3>& turn) {
    const Mat<double, 3, 3> m = (math::exp_so3<double>(turn) * R).toRotationMatrix();
    return Vec<double, 3>{std::atan2(m(2, 1), m(2, 2)), -std::asin(m(2, 0)), std::atan2(m(1, 0), m(0, 0))};
  };
  Mat8 J = Mat8::Identity();
  for (int c = 0; c < 3; ++c) {
    const Vec<double, 3> step = 1e-6 * Vec<double, 3>::Unit(c);
    J.block<3, 1>(3, 3 + c) = (angles(step) - angles(-step)) / 2e-6;
  }
  Vec8 deviation = (J * covariance * J.transpose()).diagonal().cwiseSqrt();
  for (int i = 0; i < kDof; ++i) deviation[i] *= i < 3 || i > 5 ? 1000 : 1 / kDegree;
  return deviation;
}

std::string numbers(const Vec8& values) {
  std::string text;
  for (const double x : values) text += fmt::format("{}{:.3f}", text.empty() ? "" : " ", x);
  return text;
}

template <class M, class S>
model::Configuration<M, S> cast(const model::Configuration<M, double>& q) {
  model::Configuration<M, S> out;
  out.T_cam_obj = {q.T_cam_obj.R.template cast<S>(), q.T_cam_obj.t.template cast<S>()};
  out.joints = q.joints.template cast<S>();
  return out;
}

/// From a start off by 2 cm, 5 degrees and 1 cm, nothing known before.
template <class M, class S>
model::Configuration<M, double> solved(const Images& images, double noise_px,
                                       const model::Configuration<M, double>& start) {
  const auto start_s = cast<M, S>(start);
  const auto solution = tracker::solve<M, S>(matches_of<M, S>(images, {noise_px, 0}), {.mean = start_s}, start_s, 20);
  model::Configuration<M, double> q;
  q.T_cam_obj = {solution.q.T_cam_obj.R.template cast<double>(), solution.q.T_cam_obj.t.template cast<double>()};
  q.joints = solution.q.joints.template cast<double>();
  return q;
}

template <class M>
void measure(const Run& run, Table& table, const char* name, const model::Configuration<M, double>& truth,
             const Published& published) {
  const Vec8 of_points =
      in_published_units(information<M>(truth, variances_of({0.3, 0}), 0).inverse(), truth.T_cam_obj.R);
  double apart = 0;
  for (int i = 0; i < kDof; ++i) {
    apart = std::max(apart, std::abs(of_points[i] / published[static_cast<std::size_t>(i)] - 1));
  }
  table.tell(fmt::format("{}: bound of projected points at 0.3 px, x y z mm, roll pitch yaw deg, q1 q2 mm", name),
             fmt::format("{}; published {}; {:.1f} % apart", numbers(of_points),
                         numbers(Eigen::Map<const Vec8>(published.data())), 100 * apart));
  const Images images = images_of<M>(truth);
  const Vec8 off{0.02 / std::sqrt(3), -0.02 / std::sqrt(3), 0.02 / std::sqrt(3), 0.05, -0.05, 0.05, 0.01, 0.01};
  const auto start = model::integrate<M, double>(truth, off);
  for (const double noise_px : {0.3, 0.02}) {
    run.progress(fmt::format("{}, {} px", name, noise_px));
    const Vec8 bound = deviations(information<M>(truth, variances_of({noise_px, 0})));
    test::Random random{run.seed};
    RootMeanSquare errors, errors_f, difference;
    for (int trial = 0; trial < run.trials; ++trial) {
      const Images seen = observe(images, {noise_px, 0}, random);
      const auto q = solved<M, double>(seen, noise_px, start), q_f = solved<M, float>(seen, noise_px, start);
      errors.add(model::difference<M, double>(truth, q).cwiseQuotient(bound));
      errors_f.add(model::difference<M, double>(truth, q_f).cwiseQuotient(bound));
      difference.add(model::difference<M, double>(q, q_f).cwiseQuotient(bound));
    }
    const auto row = [&](const char* scalar, const Vec8& ratio) {
      table.row(fmt::format("{}, {} px, {}: RMS / bound, least and most of 8", name, noise_px, scalar), "0.97-1.03",
                fmt::format("{:.3f}-{:.3f}", ratio.minCoeff(), ratio.maxCoeff()),
                ratio.minCoeff() >= 0.97 && ratio.maxCoeff() <= 1.03);
    };
    row("double", errors.value());
    row("float", errors_f.value());
    const double most = difference.value().maxCoeff();
    table.row(fmt::format("{}, {} px: float from double, RMS / deviation, most of 8", name, noise_px), "0.01",
              fmt::format("{:.4f}", most), most <= 0.01);
  }
}

}  // namespace

void crb(const Run& run, Table& table) {
  using F = FreePrinter;
  measure<F>(run, table, "open, 0.7 m", nominal<F>(), {.175, .235, 1.046, .311, .293, .062, .622, .500});
  measure<F>(run, table, "closed", configuration<F>(0.70, {5, -10, 30}, 0, 0.12),
             {.198, .235, .972, .314, .279, .063, .906, .546});
  measure<F>(run, table, "fronto-parallel", configuration<F>(0.70, {0, 0, 0}, 0.08, 0.12),
             {.198, .217, .976, .790, .265, .071, 2.483, .915});
  measure<F>(run, table, "open, 0.6 m", configuration<F>(0.60, {5, -10, 30}, 0.08, 0.12),
             {.152, .198, .754, .258, .239, .053, .519, .430});
  measure<F>(run, table, "open, 0.8 m", configuration<F>(0.80, {5, -10, 30}, 0.08, 0.12),
             {.199, .273, 1.384, .365, .348, .071, .727, .570});
  measure<DeepPrinter>(run, table, "base not flat", nominal<DeepPrinter>(),
                       {.275, .348, 1.187, .181, .178, .077, .582, .545});
}

}  // namespace articam::estimator_table
