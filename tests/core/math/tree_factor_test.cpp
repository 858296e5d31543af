#include "core/math/tree_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/support/random_state.hpp"

namespace articam {
namespace {

/// Every unknown depends on every other: nothing can be left out.
struct Chain {
  static constexpr std::array<int, 8> kParent{-1, 0, 1, 2, 3, 4, 5, 6};
};
/// Three branches, two of which fork again.
struct Branches {
  static constexpr std::array<int, 11> kParent{-1, 0, 1, 2, 3, 3, 1, 6, 6, 0, 9};
};
/// Too large for straight code.
struct LongChain {
  static constexpr std::array<int, 16> kParent{-1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
};
static_assert(math::TreePattern<Chain>::kNumUpdates == 84, "n (n^2 - 1) / 6 of a dense matrix");
static_assert(math::TreePattern<Chain>::kStraight && !math::TreePattern<LongChain>::kStraight);

/// A^T A with rows of A that each touch one unknown and all on its way to the root.
template <class Tree>
math::TreeMatrix<Tree, double> random_normal_matrix(test::Random& random) {
  constexpr int kSize = math::TreePattern<Tree>::kSize;
  math::TreeMatrix<Tree, double> H{};
  for (int leaf = 0; leaf < kSize; ++leaf) {
    for (int repeat = 0; repeat < 2; ++repeat) {
      Vec<double, kSize> row = Vec<double, kSize>::Zero();
      for (int i = leaf; i >= 0; i = math::TreePattern<Tree>::parent(i)) row[i] = random.uniform(-1, 1);
      for (int i = leaf; i >= 0; i = math::TreePattern<Tree>::parent(i)) {
        for (int j = i; j >= 0; j = math::TreePattern<Tree>::parent(j)) H.at(i, j) += row[i] * row[j];
      }
    }
  }
  return H;
}

template <class Tree>
class TreeFactor : public testing::Test {};
using Trees = testing::Types<Chain, Branches, LongChain>;
TYPED_TEST_SUITE(TreeFactor, Trees);

TYPED_TEST(TreeFactor, SolvesAsADenseMatrixDoes) {
  constexpr int kSize = math::TreePattern<TypeParam>::kSize;
  test::Random random{21};
  for (int i = 0; i < 100; ++i) {
    const auto H = random_normal_matrix<TypeParam>(random);
    Mat<double, kSize, kSize> dense;
    for (int r = 0; r < kSize; ++r) {
      for (int c = 0; c < kSize; ++c) dense(r, c) = H(r, c);
    }
    for (const double damping : {0.0, 0.5}) {
      Mat<double, kSize, kSize> damped = dense;
      damped.diagonal() *= 1 + damping;
      const Vec<double, kSize> b = random.vector<double, kSize>(-1, 1);
      math::TreeFactor<TypeParam, double> factor;
      ASSERT_EQ(factor.factorise(H, damping), Status::ok);
      Vec<double, kSize> x = b;
      factor.solve(x.data(), x.data());
      // Both are stable: what is left over is rounding of H x.
      EXPECT_LT((damped * x - b).norm(), 1e-13 * damped.norm() * x.norm());
    }
  }
}

TYPED_TEST(TreeFactor, RefusesAMatrixThatIsNotPositiveDefiniteOrNotANumber) {
  test::Random random{22};
  constexpr int kSize = math::TreePattern<TypeParam>::kSize;
  for (int bad = 0; bad < kSize; ++bad) {
    for (const double value : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
      auto H = random_normal_matrix<TypeParam>(random);
      H.at(bad, bad) = value;
      math::TreeFactor<TypeParam, double> factor;
      EXPECT_EQ(factor.factorise(H), Status::ill_conditioned) << bad << ' ' << value;
    }
  }
}

}  // namespace
}  // namespace articam
