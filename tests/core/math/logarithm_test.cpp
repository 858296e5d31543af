#include "core/math/logarithm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace articam::math {
namespace {

template <class S>
class Logarithm : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Logarithm, Scalars);

TYPED_TEST(Logarithm, IsThatOfTheLibraryAtEveryMagnitude) {
  using Limits = std::numeric_limits<TypeParam>;
  const double most = std::log(static_cast<double>(Limits::max())),
               least = std::log(static_cast<double>(Limits::min()));
  for (int k = 0; k < 100'000; ++k) {
    const auto x = static_cast<TypeParam>(std::exp(least + (most - least) * (k + 0.5) / 100'000));
    const double want = std::log(static_cast<double>(x));
    // What is left out of the series, and the rounding of the result and of its largest term.
    ASSERT_NEAR(static_cast<double>(log(x)), want, 1e-7 + 2 * static_cast<double>(Limits::epsilon()) * std::abs(want));
  }
}

TYPED_TEST(Logarithm, IsExactlyZeroAtOneAndNeverFalls) {
  EXPECT_EQ(log(TypeParam(1)), TypeParam(0));
  static_assert(log(TypeParam(1)) == TypeParam(0));
  TypeParam last = log(TypeParam(0.25));
  for (int k = 1; k <= 4000; ++k) {  // past two places where the exponent changes
    const TypeParam next = log(TypeParam(0.25) + TypeParam(k) / TypeParam(1024));
    EXPECT_GT(next, last);
    last = next;
  }
}

}  // namespace
}  // namespace articam::math
