#include "tools/identify/arrow.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace articam::identify {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr int kMoments = 4, kOwn = 3, kShared = 2, kAll = kMoments * kOwn + kShared;

/// An arrow, and the same equations as one dense matrix.
struct Equations {
  Arrow arrow;
  MatrixXd H = MatrixXd::Zero(kAll, kAll);
  VectorXd pull = VectorXd::Zero(kAll);

  Equations() {
    std::srand(1);  // Eigen's random numbers
    arrow.shared = MatrixXd::Zero(kShared, kShared);
    arrow.pull = VectorXd::Zero(kShared);
    for (int i = 0; i < kMoments; ++i) {
      const MatrixXd J = 1e4 * MatrixXd::Random(6, kOwn + kShared);  // beside which a metre's prior is nothing
      const MatrixXd N = J.transpose() * J;
      const VectorXd g = J.transpose() * VectorXd::Random(6);
      arrow.moments.push_back({N.topLeftCorner(kOwn, kOwn), N.topRightCorner(kOwn, kShared), g.head(kOwn)});
      arrow.shared += N.bottomRightCorner(kShared, kShared);
      arrow.pull += g.tail(kShared);
      H.block(i * kOwn, i * kOwn, kOwn, kOwn) = arrow.moments.back().own;
      H.block(i * kOwn, kAll - kShared, kOwn, kShared) = arrow.moments.back().cross;
      H.block(kAll - kShared, i * kOwn, kShared, kOwn) = arrow.moments.back().cross.transpose();
      pull.segment(i * kOwn, kOwn) = arrow.moments.back().pull;
    }
    H.bottomRightCorner(kShared, kShared) = arrow.shared;
    pull.tail(kShared) = arrow.pull;
  }
};

TEST(Arrow, SolvesWhatTheDenseEquationsSolve) {
  const Equations equations;
  const VectorXd dense = equations.H.partialPivLu().solve(equations.pull);
  const ArrowStep step = equations.arrow.solve(0);
  // The prior of a metre is 1 beside information of 1e8.
  EXPECT_LT((step.shared - dense.tail(kShared)).norm(), 1e-6 * dense.norm());
  for (int i = 0; i < kMoments; ++i) {
    const VectorXd own = dense.segment(i * kOwn, kOwn);
    EXPECT_LT((step.own[static_cast<std::size_t>(i)] - own).norm(), 1e-6 * dense.norm());
  }
}

TEST(Arrow, KnowsTheInformationAboutTheSharedUnknowns) {
  const Equations equations;
  const MatrixXd covariance = equations.H.inverse().bottomRightCorner(kShared, kShared);
  const MatrixXd one = equations.arrow.reduced() * covariance;
  EXPECT_LT((one - MatrixXd::Identity(kShared, kShared)).norm(), 1e-6);
}

TEST(Arrow, AnUnknownThatNothingTellsStays) {
  Equations equations;
  equations.arrow.moments[0].own.setZero();
  equations.arrow.moments[0].cross.setZero();
  equations.arrow.moments[0].pull.setZero();
  EXPECT_EQ(equations.arrow.solve(0).own[0].norm(), 0);
}

TEST(Marginal, IsTheInverseOfTheCovariancesCorner) {
  const Equations equations;
  const MatrixXd corner = equations.H.inverse().topLeftCorner(kOwn, kOwn);
  EXPECT_LT((marginal(equations.H, kOwn) * corner - MatrixXd::Identity(kOwn, kOwn)).norm(), 1e-6);
}

}  // namespace
}  // namespace articam::identify
