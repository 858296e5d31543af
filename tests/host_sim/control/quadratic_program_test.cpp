#include "host_sim/control/quadratic_program.hpp"

#include <gtest/gtest.h>

#include <coin/ClpSimplex.hpp>
#include <optional>
#include <vector>

#include "host_sim/world/hash.hpp"

namespace articam::sim {
namespace {

template <class Matrix>
void fill(Dice& dice, Matrix& m, int rows, int cols) {
  m.resize(rows, cols);
  for (int i = 0; i < m.size(); ++i) m.data()[i] = dice.between(-1, 1) + dice.between(-1, 1);
}

/// As many constraints as a controller has, more or fewer. `degenerate`: rows repeated, scaled and combined, and many
/// of them tight at one point. Without it, that point is inside.
QuadraticProgram random_program(Dice& dice, bool degenerate) {
  const int n = 2 + static_cast<int>(dice.between(0, 18));
  const int m = static_cast<int>(dice.between(0, n)), p = static_cast<int>(dice.between(0, 60));
  QuadraticProgram program;
  QpMat root;
  fill(dice, root, n, n);
  program.H = root.transpose() * root + 0.1 * QpMat::Identity(n, n);
  fill(dice, program.g, n, 1);
  program.g *= 3;
  fill(dice, program.E, m, n);
  fill(dice, program.C, p, n);
  QpVec point;
  fill(dice, point, n, 1);
  for (int i = 1; degenerate && i < m; i += 2) program.E.row(i) = -2 * program.E.row(i - 1);
  for (int i = 2; degenerate && i < p; i += 3) program.C.row(i) = program.C.row(i - 1) + 0.5 * program.C.row(i - 2);
  program.e = program.E * point;
  program.c = program.C * point;
  for (int i = 0; i < p; ++i) {
    if (!degenerate || i % 4 == 0) program.c[i] -= dice.between(0, 1);
  }
  return program;
}

double cost(const QuadraticProgram& program, const QpVec& x) { return 0.5 * x.dot(program.H * x) + program.g.dot(x); }

/// Largest violation of Karush, Kuhn and Tucker's conditions: stationary, feasible, signs, complementary.
double residual(const QuadraticProgram& program, const QpSolution& s) {
  double worst =
      (program.H * s.x + program.g - program.E.transpose() * s.equality - program.C.transpose() * s.inequality)
          .cwiseAbs()
          .maxCoeff();
  if (program.e.size() > 0) worst = std::max(worst, (program.E * s.x - program.e).cwiseAbs().maxCoeff());
  for (int i = 0; i < program.c.size(); ++i) {
    const double slack = program.C.row(i).dot(s.x) - program.c[i];
    worst = std::max({worst, -slack, -s.inequality[i], std::abs(slack * s.inequality[i])});
  }
  return worst;
}

/// Now and then it walks in circles for ever where there is no feasible point; where there is one, 100 steps do.
constexpr int kClpSteps = 2000;

/// COIN-OR Clp: x, or nothing where it finds no feasible one.
std::optional<QpVec> solve_by_clp(const QuadraticProgram& program) {
  const int n = static_cast<int>(program.g.size());
  const int m = static_cast<int>(program.e.size()), p = static_cast<int>(program.c.size());
  std::vector<double> lower, upper, row(static_cast<std::size_t>(n));
  std::vector<int> columns(static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j) columns[static_cast<std::size_t>(j)] = j;
  CoinPackedMatrix rows(false, 0, 0);
  rows.setDimensions(0, n);
  for (int i = 0; i < m + p; ++i) {
    for (int j = 0; j < n; ++j) row[static_cast<std::size_t>(j)] = i < m ? program.E(i, j) : program.C(i - m, j);
    rows.appendRow(n, columns.data(), row.data());
    lower.push_back(i < m ? program.e[i] : program.c[i - m]);
    upper.push_back(i < m ? program.e[i] : COIN_DBL_MAX);
  }
  const std::vector<double> no_lower(static_cast<std::size_t>(n), -COIN_DBL_MAX);
  const std::vector<double> no_upper(static_cast<std::size_t>(n), COIN_DBL_MAX);
  ClpSimplex clp;
  clp.setLogLevel(0);
  clp.loadProblem(rows, no_lower.data(), no_upper.data(), program.g.data(), lower.data(), upper.data());
  std::vector<int> starts, indices;
  std::vector<double> elements;
  for (int j = 0; j < n; ++j) {
    starts.push_back(static_cast<int>(indices.size()));
    for (int i = j; i < n; ++i) indices.push_back(i), elements.push_back(program.H(i, j));
  }
  starts.push_back(static_cast<int>(indices.size()));
  clp.loadQuadraticObjective(n, starts.data(), indices.data(), elements.data());
  clp.setMaximumIterations(kClpSteps);
  clp.primal();
  if (clp.status() != 0) return std::nullopt;
  const QpVec x = Eigen::Map<const Eigen::VectorXd>(clp.primalColumnSolution(), n);
  const double off = (program.E * x - program.e).lpNorm<1>() + (program.c - program.C * x).cwiseMax(0).lpNorm<1>();
  if (off > 1e-4) return std::nullopt;  // stopped on the way, whatever it says
  return x;
}

class QuadraticPrograms : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Kinds, QuadraticPrograms, testing::Values(false, true),
                         [](const auto& kind) { return kind.param ? "Degenerate" : "General"; });

TEST_P(QuadraticPrograms, MeetTheConditionsOfKarushKuhnAndTucker) {
  DualActiveSet solver;
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    Dice dice{seed};
    const QuadraticProgram program = random_program(dice, GetParam());
    QpSolution solution;
    ASSERT_EQ(solver.solve(program, solution), QpStatus::solved) << "seed " << seed;
    // H is conditioned up to 1e4: that many last bits.
    ASSERT_LT(residual(program, solution), 1e-8 * (1 + solution.x.norm())) << "seed " << seed;
  }
}

TEST_P(QuadraticPrograms, CostWhatAnotherSolverFinds) {
  DualActiveSet solver;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    Dice dice{seed};
    const QuadraticProgram program = random_program(dice, GetParam());
    QpSolution solution;
    ASSERT_EQ(solver.solve(program, solution), QpStatus::solved) << "seed " << seed;
    const auto other = solve_by_clp(program);
    ASSERT_TRUE(other) << "seed " << seed;
    const double ours = cost(program, solution.x), theirs = cost(program, *other);
    EXPECT_NEAR(ours, theirs, 1e-5 * (1 + std::abs(theirs))) << "seed " << seed;  // Clp's tolerances are 1e-7
  }
}

TEST(QuadraticProgram, IsInfeasibleWhereAnotherSolverSaysSo) {
  DualActiveSet solver;
  int infeasible = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Dice dice{seed};
    QuadraticProgram program = random_program(dice, seed % 2 == 0);
    for (double& bound : program.c) bound += dice.between(-0.5, 1);  // the point is inside no more
    if (seed % 3 == 0) {
      for (double& value : program.e) value += dice.between(-1, 1);
    }
    QpSolution solution;
    const QpStatus status = solver.solve(program, solution);
    const bool feasible = solve_by_clp(program).has_value();
    EXPECT_EQ(status, feasible ? QpStatus::solved : QpStatus::infeasible) << "seed " << seed;
    if (status == QpStatus::solved) {
      EXPECT_LT(residual(program, solution), 1e-7 * (1 + solution.x.norm())) << "seed " << seed;
    }
    infeasible += feasible ? 0 : 1;
  }
  EXPECT_GT(infeasible, 100);
  EXPECT_LT(infeasible, 300);
}

TEST(QuadraticProgram, HasNoAnswerWithoutCurvature) {
  QuadraticProgram program;
  program.H = QpMat::Identity(2, 2);
  program.H(1, 1) = 0;
  program.g = QpVec::Ones(2);
  program.E.resize(0, 2), program.C.resize(0, 2);
  QpSolution solution;
  EXPECT_EQ(DualActiveSet{}.solve(program, solution), QpStatus::not_convex);
}

}  // namespace
}  // namespace articam::sim
