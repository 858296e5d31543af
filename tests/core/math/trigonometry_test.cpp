#include "core/math/trigonometry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>

#include <gtest/gtest.h>

namespace articam::math {
namespace {

constexpr unsigned kSeed = 20240229;  // named by the failure messages
constexpr int kDraws = 100'000;

template <class S>
constexpr S kInf = std::numeric_limits<S>::infinity();
template <class S>
constexpr double kEpsilon = static_cast<double>(std::numeric_limits<S>::epsilon());
template <class S>
constexpr S kNaN = std::numeric_limits<S>::quiet_NaN();

/// |got - want| in units of the last place that `want` has in S, gradual underflow included.
template <class S>
double ulps(S got, long double want) {
  using Limits = std::numeric_limits<S>;
  int exponent;
  std::frexp(want, &exponent);
  const long double ulp = std::ldexp(1.0L, std::max(exponent, Limits::min_exponent) - Limits::digits);
  return static_cast<double>(std::abs(static_cast<long double>(got) - want) / ulp);
}

template <class S>
std::uint64_t bits(S x) {
  return std::bit_cast<std::conditional_t<sizeof(S) == 4, std::uint32_t, std::uint64_t>>(x);
}

template <class S>
class Trigonometry : public testing::Test {
 protected:
  void SetUp() override {
    if (std::numeric_limits<long double>::digits < std::numeric_limits<S>::digits + 8) {
      GTEST_SKIP() << "long double is no wider than the type under test on this machine";
    }
  }

  S draw(double from, double to) { return static_cast<S>(std::uniform_real_distribution<double>{from, to}(random_)); }
  /// A number whose exponent, not its value, is evenly spread.
  S draw_magnitude(double from_exponent, double to_exponent) {
    const S magnitude =
        static_cast<S>(std::exp2(std::uniform_real_distribution<double>{from_exponent, to_exponent}(random_)));
    return (random_() & 1) != 0 ? magnitude : -magnitude;
  }
  void expect_sin_cos_within_one_ulp(S angle) {
    const auto [sine, cosine] = sin_cos(angle);
    const auto exact = static_cast<long double>(angle);
    ASSERT_LT(ulps(sine, std::sin(exact)), 1.0) << "sin at " << angle << ", seed " << kSeed;
    ASSERT_LT(ulps(cosine, std::cos(exact)), 1.0) << "cos at " << angle << ", seed " << kSeed;
  }
  void expect_atan2_within_one_ulp(S y, S x) {
    const auto exact_y = static_cast<long double>(y), exact_x = static_cast<long double>(x);
    ASSERT_LT(ulps(atan2(y, x), std::atan2(exact_y, exact_x)), 1.0)
        << "atan2 at " << y << ", " << x << ", seed " << kSeed;
  }

 private:
  std::mt19937 random_{kSeed};
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Trigonometry, Scalars);

TYPED_TEST(Trigonometry, SinAndCosAreWithinOneUlpOverTheWholeDomain) {
  using S = TypeParam;
  constexpr auto kMax = static_cast<double>(kMaxAngle_rad<S>);
  for (int i = 0; i < kDraws; ++i) {
    this->expect_sin_cos_within_one_ulp(this->draw(-1.0, 1.0));
    this->expect_sin_cos_within_one_ulp(this->draw(-10.0, 10.0));
    this->expect_sin_cos_within_one_ulp(this->draw(-kMax, kMax));
    this->expect_sin_cos_within_one_ulp(this->draw_magnitude(-60, 13));
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(Trigonometry, SinAndCosKeepTheirAccuracyBesideEveryMultipleOfAQuarterTurn) {
  using S = TypeParam;
  constexpr long double kHalfPi = 1.57079632679489661923132169163975144L;
  const int last = static_cast<int>(kMaxAngle_rad<S> / S(1.5708));
  const int stride = last > 10'000 ? 17 : 1;  // an odd one, so that every quadrant has its turn
  for (int k = 1; k < last; k += stride) {
    const S nearest = static_cast<S>(k * kHalfPi);
    for (const S angle : {std::nextafter(nearest, S(0)), nearest, std::nextafter(nearest, kInf<S>)}) {
      this->expect_sin_cos_within_one_ulp(angle);
      if (this->HasFatalFailure()) return;
    }
  }
}

TYPED_TEST(Trigonometry, SineIsOddAndCosineEvenBitByBit) {
  using S = TypeParam;
  for (int i = 0; i < kDraws; ++i) {
    const S angle = this->draw(0, 1000);
    const auto here = sin_cos(angle), there = sin_cos(-angle);
    ASSERT_EQ(bits(there.sin), bits(-here.sin)) << angle;
    ASSERT_EQ(bits(there.cos), bits(here.cos)) << angle;
  }
  EXPECT_EQ(bits(sin_cos(S(-0.0)).sin), bits(S(-0.0)));
  EXPECT_EQ(sin_cos(S(-0.0)).cos, S(1));
}

TYPED_TEST(Trigonometry, SquaresOfSineAndCosineAddUpToOne) {
  using S = TypeParam;
  for (int i = 0; i < kDraws; ++i) {
    const S angle = this->draw(-100, 100);
    const auto [sine, cosine] = sin_cos(angle);
    // Each of the two is within 1 ulp <= epsilon / 2 of a number of at most 1, each product and the sum round once.
    ASSERT_NEAR(static_cast<double>(sine * sine + cosine * cosine), 1.0, 3.0 * kEpsilon<S>) << angle;
  }
}

TYPED_TEST(Trigonometry, AnAngleOutsideTheDomainGivesNotANumber) {
  using S = TypeParam;
  const S beyond = std::nextafter(kMaxAngle_rad<S>, kInf<S>);
  for (const S angle : {beyond, -beyond, kInf<S>, -kInf<S>, kNaN<S>}) {
    EXPECT_TRUE(std::isnan(sin_cos(angle).sin)) << angle;
    EXPECT_TRUE(std::isnan(sin_cos(angle).cos)) << angle;
  }
  this->expect_sin_cos_within_one_ulp(kMaxAngle_rad<S>);
  this->expect_sin_cos_within_one_ulp(std::numeric_limits<S>::denorm_min());
}

TYPED_TEST(Trigonometry, Atan2IsWithinOneUlpInEveryQuadrantAndAtEveryMagnitude) {
  using S = TypeParam;
  const double widest = std::numeric_limits<S>::max_exponent - 1;
  for (int i = 0; i < kDraws; ++i) {
    this->expect_atan2_within_one_ulp(this->draw(-1, 1), this->draw(-1, 1));
    this->expect_atan2_within_one_ulp(this->draw_magnitude(-widest, widest), this->draw_magnitude(-widest, widest));
    const S x = this->draw_magnitude(-widest, widest - 1);
    this->expect_atan2_within_one_ulp(x * this->draw(-1.5, 1.5), x);  // near the diagonals
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(Trigonometry, Atan2IsOddInYBitByBit) {
  using S = TypeParam;
  for (int i = 0; i < kDraws; ++i) {
    const S y = this->draw(0, 1), x = this->draw(-1, 1);
    ASSERT_EQ(bits(atan2(-y, x)), bits(-atan2(y, x))) << y << ", " << x;
  }
}

TYPED_TEST(Trigonometry, Atan2TreatsZerosInfinitiesAndSubnormalsAsTheStandardLibraryDoes) {
  using S = TypeParam;
  const S values[]{S(0),
                   S(-0.0),
                   S(1),
                   S(-1),
                   kInf<S>,
                   -kInf<S>,
                   std::numeric_limits<S>::denorm_min(),
                   -std::numeric_limits<S>::denorm_min(),
                   std::numeric_limits<S>::max()};
  for (const S y : values) {
    for (const S x : values) {
      const S ours = atan2(y, x);
      EXPECT_EQ(std::signbit(ours), std::signbit(std::atan2(y, x))) << y << ", " << x;
      this->expect_atan2_within_one_ulp(y, x);
    }
    EXPECT_TRUE(std::isnan(atan2(y, kNaN<S>)));
    EXPECT_TRUE(std::isnan(atan2(kNaN<S>, y)));
  }
}

TYPED_TEST(Trigonometry, Atan2UndoesSinCos) {
  using S = TypeParam;
  for (int i = 0; i < kDraws; ++i) {
    const S angle = this->draw(-3.1415, 3.1415);
    const auto [sine, cosine] = sin_cos(angle);
    // Two coordinates off by up to epsilon / 2 turn the angle by less than epsilon; then it rounds, at most 4 > pi.
    ASSERT_NEAR(static_cast<double>(atan2(sine, cosine)), static_cast<double>(angle), 3.0 * kEpsilon<S>);
  }
}

TYPED_TEST(Trigonometry, ExpIsWithinOneUlpFromOverflowToUnderflow) {
  using S = TypeParam;
  const double ln_max = std::log(static_cast<double>(std::numeric_limits<S>::max()));
  const double ln_min = std::log(static_cast<double>(std::numeric_limits<S>::denorm_min()));
  for (int i = 0; i < kDraws; ++i) {
    for (const S x : {this->draw(-1, 1), this->draw(ln_min, ln_max), this->draw(ln_min - 2, ln_min + 40)}) {
      ASSERT_LT(ulps(articam::math::exp(x), std::exp(static_cast<long double>(x))), 1.0)
          << "exp at " << x << ", seed " << kSeed;
    }
  }
}

TYPED_TEST(Trigonometry, ExpSaturatesAtInfinityAndZero) {
  using S = TypeParam;
  EXPECT_EQ(articam::math::exp(S(0)), S(1));
  EXPECT_EQ(articam::math::exp(S(-0.0)), S(1));
  EXPECT_EQ(articam::math::exp(S(1e5)), kInf<S>);
  EXPECT_EQ(articam::math::exp(kInf<S>), kInf<S>);
  EXPECT_EQ(articam::math::exp(S(-1e5)), S(0));
  EXPECT_EQ(articam::math::exp(-kInf<S>), S(0));
  EXPECT_TRUE(std::isnan(articam::math::exp(kNaN<S>)));
}

TYPED_TEST(Trigonometry, TheCompilerAndTheMachineComputeTheSameBits) {
  using S = TypeParam;
  constexpr S kAngle = S(123.456);
  constexpr auto folded = sin_cos(kAngle);
  constexpr S folded_atan2 = atan2(S(-0.3), S(-0.7)), folded_exp = articam::math::exp(S(-2.5));
  volatile S angle = kAngle, y = S(-0.3), x = S(-0.7), power = S(-2.5);
  EXPECT_EQ(bits(folded.sin), bits(sin_cos<S>(angle).sin));
  EXPECT_EQ(bits(folded.cos), bits(sin_cos<S>(angle).cos));
  EXPECT_EQ(bits(folded_atan2), bits(atan2<S>(y, x)));
  EXPECT_EQ(bits(folded_exp), bits(articam::math::exp<S>(power)));
}

/// Every result of a fixed walk through the arguments, folded into one number (FNV-1a). The arguments are
/// whole multiples of a power of two: exact in float and on every machine.
template <class S>
std::uint64_t fingerprint() {
  std::uint64_t hash = 14695981039346656037u;
  const auto mix = [&hash](S x) { hash = (hash ^ bits(x)) * 1099511628211u; };
  for (int i = -20'000; i <= 20'000; ++i) {
    const S x = static_cast<S>(i) / S(1024);
    const auto [sine, cosine] = sin_cos(x * S(31));
    mix(sine);
    mix(cosine);
    mix(atan2(x, S(7) - x));
    mix(articam::math::exp(x));
  }
  return hash;
}

TEST(TrigonometryBits, AreTheSameOnEveryMachineAndWithEveryCompiler) {
  EXPECT_EQ(fingerprint<float>(), 12033158682481934744u);
  EXPECT_EQ(fingerprint<double>(), 4812505916935979279u);
}

}  // namespace
}  // namespace articam::math
