#include "core/tracker/motion_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/least_squares.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/random_state.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;
using Motion = tracker::Motion<M, double>;
using Whole = Mat<double, 16, 16>;  // (q, qdot)
using Square = Motion::Square;
using Vec8 = Vec<double, 8>;
constexpr double kPeriod_s = 1.0 / 30;
const Vec8 kDensity = (Vec8{} << 1, 1, 1, 25, 25, 25, 1, 1).finished();

Whole whole(const Motion& m) {
  Whole P;
  P << m.P_qq, m.P_vq.transpose(), m.P_vq, m.P_vv;
  return P;
}

/// A covariance with correlations, of the size of what a few frames leave.
Whole random_covariance(test::Random& random, double size) {
  Whole A;
  for (int i = 0; i < A.size(); ++i) A.data()[i] = random.gaussian();
  return size * size / 16 * A * A.transpose();
}

void set(const Whole& P, Motion& m) {
  m.P_qq = P.topLeftCorner<8, 8>();
  m.P_vq = P.bottomLeftCorner<8, 8>();
  m.P_vv = P.bottomRightCorner<8, 8>();
}

Motion moved_by(Motion m, const Vec<double, 16>& error) {
  m.q = model::integrate<M, double>(m.q, error.head<8>());
  m.qdot += error.tail<8>();
  return m;
}

Vec<double, 16> error_of(const Motion& mean, const Motion& truth) {
  return (Vec<double, 16>{} << model::difference<M, double>(mean.q, truth.q), truth.qdot - mean.qdot).finished();
}

TEST(MotionFilter, CarriesTheCovarianceAsTheTransitionCarriesErrors) {
  test::Random random{1};
  for (const double rate : {0.0, 0.02, 2.0}) {
    Motion m{.q = test::nominal_printer<M, double>()};
    for (int i = 0; i < 8; ++i) m.qdot[i] = rate * random.gaussian();
    set(random_covariance(random, 0.01), m);
    auto after = m;
    tracker::advance(after, kPeriod_s, kDensity);

    constexpr double kStep = 1e-5;
    Whole F;
    for (int i = 0; i < 16; ++i) {
      const auto half = [&](double sign) {
        auto moved = moved_by(m, sign * kStep * Vec<double, 16>::Unit(i));
        tracker::advance(moved, kPeriod_s, kDensity);
        return error_of(after, moved);
      };
      F.col(i) = (half(1) - half(-1)) / (2 * kStep);
    }
    Whole expected = F * whole(m) * F.transpose();
    for (int i = 0; i < 8; ++i) {
      const double s = kDensity[i], dt = kPeriod_s;
      expected(i, i) += s * dt * dt * dt / 3;
      expected(8 + i, 8 + i) += s * dt;
      expected(i, 8 + i) += s * dt * dt / 2, expected(8 + i, i) += s * dt * dt / 2;
    }
    // The turn by a wrong rate is taken for a turn after the right one: half the angle of a frame is the bracket.
    const double bracket = 0.5 * m.qdot.segment<3>(3).norm() * kPeriod_s;
    EXPECT_LT((whole(after) - expected).norm(), (1e-8 + bracket) * expected.norm()) << rate;
  }
}

TEST(MotionFilter, TakesAMeasurementOfQAsTheTextbookFilterDoes) {
  test::Random random{2};
  Motion m{.q = test::nominal_printer<M, double>()};
  set(random_covariance(random, 0.01), m);
  const Whole P = whole(m);
  const Square R = random_covariance(random, 0.003).topLeftCorner<8, 8>();
  Mat<double, 8, 16> H = Mat<double, 8, 16>::Zero();
  H.leftCols<8>().setIdentity();
  Vec8 surprise;
  for (int i = 0; i < 8; ++i) surprise[i] = i == 3 || i == 4 || i == 5 ? 0 : 0.01 * random.gaussian();  // no bracket
  const Mat<double, 16, 8> K = P * H.transpose() * (H * P * H.transpose() + R).inverse();
  const Whole after = (Whole::Identity() - K * H) * P;
  const Vec<double, 16> step = K * surprise;
  const Motion before = m;
  const auto q = model::integrate<M, double>(m.q, Vec8{step.head<8>()});
  tracker::correct<M, double>(m, m.P_qq.inverse(), q, after.topLeftCorner<8, 8>());
  EXPECT_LT((error_of(before, m) - step).norm(), 1e-9 * step.norm() + 1e-12);
  EXPECT_LT((whole(m) - after).norm(), 1e-9 * P.norm());
}

template <class To, class From>
model::Configuration<M, To> as(const model::Configuration<M, From>& q) {
  return {{q.T_cam_obj.R.template cast<To>(), q.T_cam_obj.t.template cast<To>()}, q.joints.template cast<To>()};
}

/// One object that follows the law and one filter behind it, over `frames`: the sum of normalised squared errors.
template <class S>
double nees_of_a_run(test::Random& random, int frames, int& n) {
  tracker::Motion<M, S> filter{.q = test::nominal_printer<M, S>()};
  Motion truth{.q = test::nominal_printer<M, double>()};
  filter.P_qq = Mat<S, 8, 8>::Identity() * S(1e-2), filter.P_vv = Mat<S, 8, 8>::Identity() * S(1e-2);
  Vec8 start;
  for (int i = 0; i < 8; ++i) start[i] = 0.1 * random.gaussian(), truth.qdot[i] = 0.1 * random.gaussian();
  truth.q = model::integrate<M, double>(truth.q, start);
  const Vec<S, 8> density = kDensity.template cast<S>();
  double sum = 0;
  for (int k = 0; k < frames; ++k) {
    // Hardly observed along one direction, as a drawer along the axis of the camera.
    Vec8 deviation = Vec8::Constant(2e-4);
    deviation[2] = 2e-3, deviation[6] = k % 40 < 20 ? 2e-4 : 1e3;
    const Vec8 noise = deviation.unaryExpr([&](double d) { return d * random.gaussian(); });
    const auto seen = as<S>(model::integrate<M, double>(truth.q, noise));
    const Mat<S, 8, 8> information = filter.P_qq.inverse();
    const Vec<S, 8> weight = deviation.template cast<S>().cwiseAbs2().cwiseInverse();
    const Mat<S, 8, 8> H = information + Mat<S, 8, 8>(weight.asDiagonal());
    const Mat<S, 8, 8> P = H.inverse();
    const Vec<S, 8> step = P * weight.cwiseProduct(model::difference<M, S>(filter.q, seen));
    tracker::correct<M, S>(filter, information, model::integrate<M, S>(filter.q, step), P);
    if (k >= 5) {
      const Motion mean{.q = as<double>(filter.q), .qdot = filter.qdot.template cast<double>()};
      Whole joint;
      joint << filter.P_qq.template cast<double>(), filter.P_vq.transpose().template cast<double>(),
          filter.P_vq.template cast<double>(), filter.P_vv.template cast<double>();
      const Vec<double, 16> error = error_of(mean, truth);
      sum += error.dot(joint.ldlt().solve(error));
      ++n;
    }
    // The same noise as the law's, exactly: its two integrals over the span are correlated.
    tracker::advance<M, S>(filter, S(kPeriod_s), density);
    Vec8 push, drift;
    for (int i = 0; i < 8; ++i) {
      const double a = random.gaussian(), b = random.gaussian(), s = std::sqrt(kDensity[i] * kPeriod_s);
      push[i] = s * a;
      drift[i] = s * kPeriod_s * (0.5 * a + b / std::sqrt(12.0));
    }
    truth.q = model::integrate<M, double>(truth.q, truth.qdot * kPeriod_s + drift);
    truth.qdot += push;
  }
  return sum;
}

TEST(MotionFilter, KnowsHowSureItIsOfValuesAndRates) {
  for (const bool single : {false, true}) {
    test::Random random{3};
    int n = 0;
    double sum = 0;
    for (int run = 0; run < 400; ++run) {
      sum += single ? nees_of_a_run<float>(random, 60, n) : nees_of_a_run<double>(random, 60, n);
    }
    const double mean = sum / n;
    // Errors of successive frames are correlated: at least one in ten frames counts as independent.
    const double band = 4 * std::sqrt(2 * 16.0 / (0.1 * n));
    EXPECT_NEAR(mean, 16, band) << (single ? "float" : "double") << " over " << n;
    RecordProperty("nees", std::to_string(mean));
  }
}

}  // namespace
}  // namespace articam
