#include "core/math/so3.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace articam::math {
namespace {

constexpr unsigned kSeed = 7;  // named by every failure message
constexpr int kDraws = 2'000;

template <class S>
class So3 : public testing::Test {
 protected:
  static constexpr S kEpsilon = std::numeric_limits<S>::epsilon();

  Vec<S, 3> draw_vector() {
    std::uniform_real_distribution<double> u{-1.0, 1.0};
    Vec<double, 3> v;
    do {
      v = {u(random_), u(random_), u(random_)};
    } while (v.norm() < 0.1);
    return v.cast<S>();
  }
  Vec<S, 3> draw_rotation_vector(S angle_rad) { return draw_vector().normalized() * angle_rad; }

 private:
  std::mt19937 random_{kSeed};
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(So3, Scalars);

using WideMatrix = Mat<long double, 3, 3>;

/// The matrix exponential by its own series, independent of sin and cos; 40 terms are enough for |m| <= pi.
WideMatrix exponential_series(const WideMatrix& m) {
  WideMatrix sum = WideMatrix::Identity(), term = sum;
  for (int i = 1; i < 40; ++i) sum += term = (term * m / i).eval();
  return sum;
}

/// Angles on both sides of every branch, up to just below half a turn.
constexpr double kAngles_rad[]{0.0,  1e-12, 1e-6, 1e-5, 1.2e-4, 1.3e-4, 3e-4, 1e-3,   0.018,
                               0.02, 0.1,   0.5,  1.0,  2.0,    3.0,    3.14, 3.14159};

TYPED_TEST(So3, HatTurnsACrossProductIntoAMatrixProduct) {
  for (int i = 0; i < kDraws; ++i) {
    const auto v = this->draw_vector(), p = this->draw_vector();
    ASSERT_LE((hat(v) * p - v.cross(p)).norm(), 2 * this->kEpsilon)
        << "seed " << kSeed;  // same products, summed in another order
    ASSERT_EQ(hat(v).transpose(), -hat(v));
  }
}

TYPED_TEST(So3, ExpIsTheMatrixExponentialOfHat) {
  using S = TypeParam;
  for (const double angle : kAngles_rad) {
    for (int i = 0; i < 50; ++i) {
      const Vec<S, 3> phi = this->draw_rotation_vector(static_cast<S>(angle));
      const WideMatrix expected = exponential_series(hat<long double>(phi.template cast<long double>()));
      const WideMatrix got = exp_so3(phi).toRotationMatrix().template cast<long double>();
      // A rounded quaternion, squared into a matrix: about eight roundings of numbers up to 2.
      ASSERT_LT((got - expected).cwiseAbs().maxCoeff(), 8 * this->kEpsilon) << angle << " rad, seed " << kSeed;
    }
  }
}

TYPED_TEST(So3, ExpGivesUnitQuaternions) {
  using S = TypeParam;
  for (const double angle : kAngles_rad) {
    const Quat<S> q = exp_so3(this->draw_rotation_vector(static_cast<S>(angle)));
    EXPECT_LE(std::abs(q.norm() - S(1)), 2 * this->kEpsilon) << angle << " rad";
  }
}

TYPED_TEST(So3, LogUndoesExpUpToHalfATurn) {
  using S = TypeParam;
  for (const double angle : kAngles_rad) {
    for (int i = 0; i < 50; ++i) {
      const Vec<S, 3> phi = this->draw_rotation_vector(static_cast<S>(angle));
      // Relative: near zero the last bits of a small rotation must survive.
      ASSERT_LE((log_so3(exp_so3(phi)) - phi).norm(), 4 * this->kEpsilon * phi.norm())
          << angle << " rad, seed " << kSeed;
    }
  }
}

TYPED_TEST(So3, ExpUndoesLogForEveryRotation) {
  using S = TypeParam;
  for (int i = 0; i < kDraws; ++i) {
    const Quat<S> q = exp_so3(this->draw_rotation_vector(S(i) * S(0.005)));  // up to 10 rad: more than a turn
    const Vec<S, 3> phi = log_so3(q);
    ASSERT_LE(phi.norm(), std::numbers::pi_v<S> * (1 + 2 * this->kEpsilon));
    const Quat<S> back = exp_so3(phi);
    const S sign = back.dot(q) < 0 ? S(-1) : S(1);
    ASSERT_LE((sign * back.coeffs() - q.coeffs()).norm(), 4 * this->kEpsilon) << "seed " << kSeed;
  }
}

TYPED_TEST(So3, LogOfAHalfTurnHasLengthPi) {
  using S = TypeParam;
  for (int i = 0; i < 50; ++i) {
    const Vec<S, 3> axis = this->draw_vector().normalized();
    for (const S w : {S(0), S(-0.0), std::numeric_limits<S>::denorm_min()}) {
      const Vec<S, 3> phi = log_so3(Quat<S>(w, axis.x(), axis.y(), axis.z()));
      ASSERT_LE(std::abs(phi.norm() - std::numbers::pi_v<S>), 4 * this->kEpsilon);
      ASSERT_GT(phi.dot(axis), 0);
    }
  }
}

TYPED_TEST(So3, AQuaternionAndItsNegativeHaveTheSameLog) {
  using S = TypeParam;
  for (int i = 0; i < kDraws; ++i) {
    const Quat<S> q = exp_so3(this->draw_rotation_vector(S(i) * S(0.0015)));
    ASSERT_EQ(log_so3(q), log_so3(Quat<S>(-q.w(), -q.x(), -q.y(), -q.z())));
  }
}

TYPED_TEST(So3, TheOppositeVectorIsTheInverseRotation) {
  using S = TypeParam;
  for (const double angle : kAngles_rad) {
    const Vec<S, 3> phi = this->draw_rotation_vector(static_cast<S>(angle));
    EXPECT_EQ(exp_so3<S>(-phi).coeffs(), exp_so3(phi).conjugate().coeffs()) << angle << " rad";
  }
}

}  // namespace
}  // namespace articam::math
