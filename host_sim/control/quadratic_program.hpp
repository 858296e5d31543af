#pragma once
/// @file  A small dense convex quadratic program, and its solver.

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace articam::sim {

inline constexpr int kMaxVariables = 24, kMaxEqualities = 24, kMaxInequalities = 96;
using QpVec = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxVariables, 1>;
using QpMat = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxVariables, kMaxVariables>;
template <int MaxRows>
using QpRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, MaxRows, kMaxVariables>;
template <int MaxRows>
using QpColumn = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, MaxRows, 1>;

/// Least x^T H x / 2 + g^T x  where  E x = e  and  C x >= c.
/// Shapes  H n x n, symmetric and positive definite; E m x n; C p x n. m or p may be 0.
struct QuadraticProgram {
  QpMat H;
  QpVec g;
  QpRows<kMaxEqualities> E;
  QpColumn<kMaxEqualities> e;
  QpRows<kMaxInequalities> C;
  QpColumn<kMaxInequalities> c;
};

enum class QpStatus {
  solved,
  infeasible,  ///< no x meets all constraints
  not_convex,  ///< H has no Cholesky factor
  stalled,     ///< kMaxSteps changes of the active set were not enough
};

/// Where  H x + g = E^T equality + C^T inequality,  inequality >= 0, and 0 where C x > c.
struct QpSolution {
  QpVec x;
  QpColumn<kMaxEqualities> equality;
  QpColumn<kMaxInequalities> inequality;
  int steps{};  ///< changes of the active set
};

/// Starts at the unconstrained optimum and takes in one violated constraint after another; needs no feasible start.
/// No heap. On anything but `solved`, `out` means nothing.
/// Source  Goldfarb & Idnani, "A numerically stable dual method for solving strictly convex quadratic programs",
///         Mathematical Programming 27, 1983. Letters as there.
class DualActiveSet {
 public:
  static constexpr int kMaxSteps = 500;

  QpStatus solve(const QuadraticProgram& program, QpSolution& out) noexcept;

 private:
  /// Of the active set: an equality is its row, an inequality its row + kMaxEqualities.
  using Row = int;
  enum class Outcome { added, needless, infeasible };

  bool factorise(const QpMat& H) noexcept;
  QpVec normal(Row row) const noexcept;
  double slack(Row row, const QpVec& x) const noexcept;
  Row most_violated(const QpVec& x) const noexcept;
  Outcome take_in(Row row, QpSolution& out) noexcept;
  void add(Row row, double multiplier) noexcept;
  void remove(int position) noexcept;
  bool has(Row row) const noexcept;

  const QuadraticProgram* program_{};
  int n_{}, q_{};  ///< variables, active constraints
  QpMat J_;        ///< L^-T Q: its first q columns span the active normals, the others what they leave free
  QpMat R_;        ///< upper triangular, q x q: active normals N = L Q [R; 0]
  QpVec d_;        ///< J^T times the newest normal
  std::array<Row, static_cast<std::size_t>(kMaxVariables)> active_{};
  std::array<double, static_cast<std::size_t>(kMaxVariables)> multiplier_{};
  std::array<double, static_cast<std::size_t>(kMaxInequalities)> scale_{};
};

}  // namespace articam::sim
