#include "core/math/least_squares.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/support/random_state.hpp"

namespace articam {
namespace {

template <int M, int N>
Mat<double, M, N> random_matrix(test::Random& random) {
  Mat<double, M, N> A;
  for (int i = 0; i < M; ++i) A.row(i) = random.vector<double, N>(-1, 1).transpose();
  return A;
}

TEST(PseudoInverse, EqualsThatOfTheSvdForAnyRank) {
  test::Random random{22};
  for (int rank = 1; rank <= 8; ++rank) {
    for (int i = 0; i < 20; ++i) {
      Mat<double, 12, 8> A = random_matrix<12, 8>(random);
      for (int c = rank; c < 8; ++c) A.col(c) = A.leftCols(rank) * random.vector<double, 8>(-1, 1).head(rank);
      const Vec<double, 12> b = random.vector<double, 12>(-1, 1);
      Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
      svd.setThreshold(1e-6);
      const Vec<double, 8> expected = svd.solve(b);
      EXPECT_LT((math::pseudo_inverse_times<double, 12, 8>(A, b) - expected).norm(), 1e-9 * (1 + expected.norm()))
          << rank;
    }
  }
}

TEST(SymmetricEigen, TakesAMatrixApartAndPutsItTogetherAgain) {
  test::Random random{23};
  for (int i = 0; i < 50; ++i) {
    const auto A = random_matrix<8, 8>(random);
    const Mat<double, 8, 8> D = A + A.transpose();
    const math::SymmetricEigen<double, 8> eigen(D);
    EXPECT_LT((eigen.V * eigen.values.asDiagonal() * eigen.V.transpose() - D).norm(), 1e-13);
    EXPECT_LT((eigen.V.transpose() * eigen.V - Mat<double, 8, 8>::Identity()).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace articam
