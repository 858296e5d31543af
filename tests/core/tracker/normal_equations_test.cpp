#include "core/tracker/normal_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/tracker/vvs.hpp"
#include "static_models/registry.hpp"
#include "tests/support/observe.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using tracker::FeatureKind;

/// Compiled once for each model: what is unrolled over a table takes a compiler seconds.
template <class M, class S>
[[gnu::noinline]] tracker::Normal<M, S> equations_of(const tracker::Matches<M, S>& matches,
                                                     const model::Configuration<M, S>& q, FeatureKind kind) {
  return tracker::linearise(matches, q, kind);
}

/// What the equations are, from the dense A of articulation_matrix.hpp, in double.
struct Dense {
  Eigen::MatrixXd H;
  Eigen::VectorXd b;
  double cost{}, chi2{}, error2{};

  void add(const Eigen::MatrixXd& A, const Eigen::VectorXd& e, double variance) {
    const double distance2 = e.squaredNorm() / variance;
    const double size = std::max(3.0, std::sqrt(distance2));  // 3: where least squares ends
    const double weight = math::huber_weight(size, 3.0) / variance;
    H += weight * A.transpose() * A;
    b -= weight * A.transpose() * e;
    cost += 0.5 * (distance2 - math::huber_excess(size, 3.0));
    chi2 += distance2;
    error2 += e.squaredNorm();
  }
};

template <class M>
Dense dense_equations(const tracker::Matches<M, double>& matches, const model::Configuration<M, double>& q,
                      FeatureKind kind) {
  constexpr int kDof = model::kDof<M>;
  Dense sum{Eigen::MatrixXd::Zero(kDof, kDof), Eigen::VectorXd::Zero(kDof)};
  tracker::System<M, double> system;
  EXPECT_EQ(stack(matches, q, kind, system), Status::ok);
  for (int i = 0; i < model::kNumMarkers<M>; ++i) {
    const auto& match = matches[static_cast<std::size_t>(i)];
    if (match.matched)
      sum.add(system.A.template middleRows<2>(2 * i), system.e.template segment<2>(2 * i), match.variance);
  }
  return sum;
}

template <class TreeMatrix>
Eigen::MatrixXd dense(const TreeMatrix& H, int size) {
  Eigen::MatrixXd full(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) full(i, j) = H(i, j);
  }
  return full;
}

/// Matches of a configuration near q, some far off, some missing.
template <class M>
tracker::Matches<M, double> disturbed_matches(const model::Configuration<M, double>& q, FeatureKind kind,
                                              test::Random& random) {
  auto matches = test::observe<M, double>(q, kind, 2.0, &random);
  for (auto& match : matches) {
    if (random.uniform(0, 1) < 0.2) match.s_star += Vec<double, 2>{0.05, -0.08};  // beyond Huber's k
    if (random.uniform(0, 1) < 0.2) match.matched = false;
  }
  return matches;
}

template <class M>
class NormalEquations : public testing::Test {};
using Models = testing::Types<models::PrinterDrawer, models::Mire, models::MireDistance, models::Door, models::Valve,
                              models::SteeringWheel, models::Cabinet, models::Laptop, models::SwitchPanel, models::Arm7,
                              models::Stress24, test::Arm, test::GearedArm>;
TYPED_TEST_SUITE(NormalEquations, Models);

TYPED_TEST(NormalEquations, AreThoseOfTheDenseArticulationMatrix) {
  using M = TypeParam;
  test::Random random{31};
  for (const auto kind : {FeatureKind::point, FeatureKind::imaged_circle}) {
    for (int i = 0; i < 20; ++i) {
      const auto q = random.configuration<M, double>();
      const auto matches = disturbed_matches<M>(q, kind, random);
      const auto normal = equations_of<M, double>(matches, q, kind);
      ASSERT_EQ(normal.status, Status::ok);
      const Dense expected = dense_equations<M>(matches, q, kind);
      // Some tens of roundings of entries of that size.
      EXPECT_LT((dense(normal.H, model::kDof<M>) - expected.H).norm(), 1e-13 * expected.H.norm());
      const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(normal.b.data(), model::kDof<M>);
      EXPECT_LT((b - expected.b).norm(), 1e-12 * std::sqrt(expected.H.norm() * expected.chi2));
      EXPECT_NEAR(normal.cost, expected.cost, 1e-12 * expected.cost);
      EXPECT_NEAR(normal.chi2, expected.chi2, 1e-12 * expected.chi2);
      EXPECT_NEAR(normal.error2, expected.error2, 1e-12 * expected.error2);
    }
  }
}

TYPED_TEST(NormalEquations, HaveTheFallingSlopeOfTheCost) {
  using M = TypeParam;
  constexpr double h = 1e-6;
  test::Random random{32};
  for (int i = 0; i < 5; ++i) {
    const auto q = random.configuration<M, double>();
    const auto matches = disturbed_matches<M>(q, FeatureKind::imaged_circle, random);
    const auto normal = equations_of<M, double>(matches, q, FeatureKind::imaged_circle);
    double scale = 1;
    for (const double b : normal.b) scale = std::max(scale, std::abs(b));
    for (int c = 0; c < model::kDof<M>; ++c) {
      const auto cost_at = [&](double along) {
        const Vec<double, model::kDof<M>> step = along * Vec<double, model::kDof<M>>::Unit(c);
        return equations_of<M, double>(matches, model::integrate<M, double>(q, step), FeatureKind::imaged_circle).cost;
      };
      const double slope = (cost_at(h) - cost_at(-h)) / (2 * h);
      EXPECT_NEAR(normal.b[static_cast<std::size_t>(c)], -slope, 1e-5 * scale) << "unknown " << c;
    }
  }
}

TYPED_TEST(NormalEquations, GiveTheCovarianceThatIsTheInverseOfTheDenseMatrix) {
  using M = TypeParam;
  using Square = Mat<double, model::kDof<M>, model::kDof<M>>;
  test::Random random{33};
  for (int i = 0; i < 10; ++i) {
    const auto q = random.configuration<M, double>();
    const auto matches = disturbed_matches<M>(q, FeatureKind::imaged_circle, random);
    const auto prior = tracker::independent_prior<M, double>(q, Vec<double, model::kDof<M>>::Constant(0.01));
    const auto normal = tracker::linearise(matches, prior, q);
    Square covariance;
    ASSERT_EQ(math::invert(normal.H, covariance), Status::ok);
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(model::kDof<M>, model::kDof<M>);
    const Eigen::MatrixXd H = dense_equations<M>(matches, q, FeatureKind::imaged_circle).H + 100 * identity;
    EXPECT_LT((H * Eigen::MatrixXd(covariance) - identity).norm(), 1e-8);  // condition up to 1e6
    EXPECT_TRUE(covariance == covariance.transpose());
  }
}

TYPED_TEST(NormalEquations, AreTheSameInFloat) {
  using M = TypeParam;
  test::Random random{34};
  for (int i = 0; i < 10; ++i) {
    const auto q = random.configuration<M, double>();
    const auto matches = disturbed_matches<M>(q, FeatureKind::imaged_circle, random);
    tracker::Matches<M, float> matches_f{};
    for (std::size_t m = 0; m < matches.size(); ++m) {
      matches_f[m].matched = matches[m].matched;
      matches_f[m].s_star = matches[m].s_star.template cast<float>();
      matches_f[m].variance = static_cast<float>(matches[m].variance);
    }
    model::Configuration<M, float> q_f;
    q_f.T_cam_obj = {q.T_cam_obj.R.template cast<float>(), q.T_cam_obj.t.template cast<float>()};
    q_f.joints = q.joints.template cast<float>();
    const auto normal = equations_of<M, double>(matches, q, FeatureKind::imaged_circle);
    const auto normal_f = equations_of<M, float>(matches_f, q_f, FeatureKind::imaged_circle);
    const double size_of_H = dense(normal.H, model::kDof<M>).norm();
    for (int r = 0; r < model::kDof<M>; ++r) {
      for (int c = 0; c <= r; ++c) {
        // Cauchy and Schwarz bound an entry by its diagonal's; the rest is rounding of what a joint leaves of terms of
        // the matrix's size.
        const double size = std::sqrt(std::abs(normal.H(r, r) * normal.H(c, c)));
        EXPECT_NEAR(normal_f.H(r, c), normal.H(r, c), 2e-5 * size + 1e-6 * size_of_H) << r << ' ' << c;
      }
    }
  }
}

TYPED_TEST(NormalEquations, SayThatTheObjectIsBehindTheCamera) {
  using M = TypeParam;
  test::Random random{35};
  auto q = random.configuration<M, double>();
  const auto matches = test::observe<M, double>(q, FeatureKind::imaged_circle);
  for (const double z : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    q.T_cam_obj.t.z() = z;
    EXPECT_EQ((equations_of<M, double>(matches, q, FeatureKind::imaged_circle).status), Status::behind_camera);
  }
}

TEST(Prior, HasTheSlopeOfItsCostHoweverFarTheConfigurationIsTurnedFromIt) {
  using M = models::PrinterDrawer;
  test::Random random{8};
  for (int trial = 0; trial < 20; ++trial) {
    const auto q = random.configuration<M, double>();
    const Mat<double, 8, 8> A = [&] {
      Mat<double, 8, 8> X;
      for (int i = 0; i < 64; ++i) X(i) = random.gaussian();
      return X;
    }();
    const tracker::Prior<M, double> prior{model::integrate<M, double>(q, random.vector<double, 8>(-0.1, 0.1)),
                                          A.transpose() * A};
    const auto cost = [&](const model::Configuration<M, double>& at) {
      tracker::Normal<M, double> normal{};
      tracker::add_prior(prior, at, normal);
      return normal.cost;
    };
    tracker::Normal<M, double> normal{};
    tracker::add_prior(prior, q, normal);
    for (int i = 0; i < 8; ++i) {
      constexpr double kStep = 1e-6;
      const Vec<double, 8> step = kStep * Vec<double, 8>::Unit(i);
      const double slope =
          (cost(model::integrate<M, double>(q, step)) - cost(model::integrate<M, double>(q, Vec<double, 8>{-step}))) /
          (2 * kStep);
      // Of the third order of a turn of 0.17: theta^3 / 720 of the pull.
      EXPECT_NEAR(-normal.b[static_cast<std::size_t>(i)], slope, 2e-5 * (A.transpose() * A).norm() * 0.3) << i;
    }
  }
}

TEST(NormalEquationsStep, LeavesItsOutputAloneWhereTheMatrixIsSingularOrNotANumber) {
  using M = models::PrinterDrawer;
  const auto q = test::nominal_printer<M, double>();
  auto matches = test::observe<M, double>(q, FeatureKind::imaged_circle);
  matches[5].matched = false;  // the only marker that marker_distance moves
  Vec<double, 8> step = Vec<double, 8>::Constant(7);
  Mat<double, 8, 8> covariance = Mat<double, 8, 8>::Constant(7);
  const auto singular = tracker::linearise(matches, q);
  EXPECT_EQ((tracker::damped_step<M, double>(singular, 0.0, step)), Status::ill_conditioned);
  EXPECT_EQ((math::invert(singular.H, covariance)), Status::ill_conditioned);
  matches = test::observe<M, double>(q, FeatureKind::imaged_circle);
  matches[2].variance = std::numeric_limits<double>::infinity();
  matches[2].s_star.x() = std::numeric_limits<double>::quiet_NaN();
  const auto not_a_number = tracker::linearise(matches, q);
  EXPECT_EQ((tracker::damped_step<M, double>(not_a_number, 0.0, step)), Status::ill_conditioned);
  EXPECT_TRUE((step.array() == 7).all() && (covariance.array() == 7).all());
}

}  // namespace
}  // namespace articam
