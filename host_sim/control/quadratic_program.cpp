#include "host_sim/control/quadratic_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace articam::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Of a constraint, by the size of its normal and bound: what rounding leaves of a tight one.
constexpr double kTight = 1e-10;
/// A normal whose part free of the active ones is smaller than this by its size depends on them.
constexpr double kDependent = 1e-10;

/// The rotation of (a, b) to (length, 0).
struct Givens {
  double cosine{1}, sine{0};

  Givens(double a, double b) noexcept {
    const double length = std::sqrt(a * a + b * b);
    if (length > 0) cosine = a / length, sine = b / length;
  }
  void apply(double& a, double& b) const noexcept {
    const double turned = cosine * a + sine * b;
    b = cosine * b - sine * a;
    a = turned;
  }
};

}  // namespace

QpStatus DualActiveSet::solve(const QuadraticProgram& program, QpSolution& out) noexcept {
  program_ = &program;
  n_ = static_cast<int>(program.g.size());
  q_ = 0;
  if (!factorise(program.H)) return QpStatus::not_convex;
  for (int i = 0; i < program.c.size(); ++i) {
    scale_[static_cast<std::size_t>(i)] = 1 / (std::abs(program.c[i]) + program.C.row(i).norm() + 1e-300);
  }
  out.steps = 0;
  out.x.setZero(n_);
  for (int k = 0; k < n_; ++k) out.x -= J_.col(k) * J_.col(k).dot(program.g);  // -H^-1 g, as H^-1 = J J^T
  for (Row row = 0; row < program.e.size(); ++row) {
    if (take_in(row, out) == Outcome::infeasible) return QpStatus::infeasible;
  }
  while (true) {
    const Row row = most_violated(out.x);
    if (row < 0) break;
    if (take_in(row, out) == Outcome::infeasible) return QpStatus::infeasible;
    if (out.steps > kMaxSteps) return QpStatus::stalled;
  }
  out.equality.setZero(program.e.size());
  out.inequality.setZero(program.c.size());
  for (int i = 0; i < q_; ++i) {
    const Row row = active_[static_cast<std::size_t>(i)];
    const double multiplier = multiplier_[static_cast<std::size_t>(i)];
    (row < kMaxEqualities ? out.equality[row] : out.inequality[row - kMaxEqualities]) = multiplier;
  }
  return QpStatus::solved;
}

/// J = L^-T of H = L L^T.
bool DualActiveSet::factorise(const QpMat& H) noexcept {
  QpMat L = QpMat::Zero(n_, n_);
  for (int j = 0; j < n_; ++j) {
    double pivot = H(j, j);
    for (int k = 0; k < j; ++k) pivot -= L(j, k) * L(j, k);
    if (!(pivot > 0)) return false;
    L(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < n_; ++i) {
      double sum = H(i, j);
      for (int k = 0; k < j; ++k) sum -= L(i, k) * L(j, k);
      L(i, j) = sum / L(j, j);
    }
  }
  J_.setZero(n_, n_);
  R_.setZero(n_, n_);
  d_.setZero(n_);
  for (int j = 0; j < n_; ++j) {  // column j of L^-1 is row j of J
    for (int i = j; i < n_; ++i) {
      double sum = i == j ? 1 : 0;
      for (int k = j; k < i; ++k) sum -= L(i, k) * J_(j, k);
      J_(j, i) = sum / L(i, i);
    }
  }
  return true;
}

QpVec DualActiveSet::normal(Row row) const noexcept {
  if (row < kMaxEqualities) return program_->E.row(row).transpose();
  return program_->C.row(row - kMaxEqualities).transpose();
}

double DualActiveSet::slack(Row row, const QpVec& x) const noexcept {
  return row < kMaxEqualities ? program_->E.row(row).dot(x) - program_->e[row]
                              : program_->C.row(row - kMaxEqualities).dot(x) - program_->c[row - kMaxEqualities];
}

bool DualActiveSet::has(Row row) const noexcept {
  return std::find(active_.begin(), active_.begin() + q_, row) != active_.begin() + q_;
}

/// The inequality that is violated most by its own size; -1 where none is.
DualActiveSet::Row DualActiveSet::most_violated(const QpVec& x) const noexcept {
  Row worst = -1;
  double least = -kTight * (1 + x.norm());
  for (int i = 0; i < program_->c.size(); ++i) {
    const Row row = i + kMaxEqualities;
    const double violation = slack(row, x) * scale_[static_cast<std::size_t>(i)];
    if (!(violation < least) || has(row)) continue;
    worst = row;
    least = violation;
  }
  return worst;
}

/// Steps of section 4 of the source: towards the constraint in the space that the active ones leave, until it is met;
/// an active inequality whose multiplier would turn negative on the way leaves first.
DualActiveSet::Outcome DualActiveSet::take_in(Row row, QpSolution& out) noexcept {
  const QpVec np = normal(row);
  const bool equality = row < kMaxEqualities;
  double multiplier = 0;
  while (out.steps <= kMaxSteps) {
    ++out.steps;
    for (int k = 0; k < n_; ++k) d_[k] = J_.col(k).dot(np);
    QpVec z = QpVec::Zero(n_), r = QpVec::Zero(n_);
    for (int k = q_; k < n_; ++k) z += J_.col(k) * d_[k];
    for (int i = q_ - 1; i >= 0; --i) {
      double sum = d_[i];
      for (int k = i + 1; k < q_; ++k) sum -= R_(i, k) * r[k];
      r[i] = sum / R_(i, i);
    }
    const double s = slack(row, out.x);
    const double free = d_.tail(n_ - q_).norm();
    const bool dependent = !(free > kDependent * d_.norm());
    const double full_step = dependent ? kInfinity : -s / (free * free);
    if (equality && dependent) {
      const double size = std::abs(program_->e[row]) + np.norm() * (1 + out.x.norm());
      return std::abs(s) <= 1e-8 * size ? Outcome::needless : Outcome::infeasible;
    }
    double partial_step = kInfinity;
    int leaving = -1;
    for (int i = 0; i < q_ && !equality; ++i) {
      const auto place = static_cast<std::size_t>(i);
      if (active_[place] < kMaxEqualities || !(r[i] > 0)) continue;
      const double until = multiplier_[place] / r[i];
      if (until < partial_step) partial_step = until, leaving = i;
    }
    const double step = std::min(partial_step, full_step);
    if (step == kInfinity) return Outcome::infeasible;
    for (int i = 0; i < q_; ++i) multiplier_[static_cast<std::size_t>(i)] -= step * r[i];
    multiplier += step;
    if (!dependent) out.x += step * z;
    if (step == full_step) {
      add(row, multiplier);
      return Outcome::added;
    }
    remove(leaving);
  }
  return Outcome::needless;  // solve() sees the count
}

/// The newest normal becomes the last active one: its d is turned into R's next column.
void DualActiveSet::add(Row row, double multiplier) noexcept {
  for (int k = n_ - 1; k > q_; --k) {
    const Givens turn{d_[k - 1], d_[k]};
    turn.apply(d_[k - 1], d_[k]);
    for (int i = 0; i < n_; ++i) turn.apply(J_(i, k - 1), J_(i, k));
  }
  for (int i = 0; i <= q_; ++i) R_(i, q_) = d_[i];
  active_[static_cast<std::size_t>(q_)] = row;
  multiplier_[static_cast<std::size_t>(q_)] = multiplier;
  ++q_;
}

void DualActiveSet::remove(int position) noexcept {
  for (int k = position; k + 1 < q_; ++k) {
    R_.col(k) = R_.col(k + 1);
    active_[static_cast<std::size_t>(k)] = active_[static_cast<std::size_t>(k) + 1];
    multiplier_[static_cast<std::size_t>(k)] = multiplier_[static_cast<std::size_t>(k) + 1];
  }
  --q_;
  for (int k = position; k < q_; ++k) {  // what now stands below the diagonal
    const Givens turn{R_(k, k), R_(k + 1, k)};
    for (int i = k; i < q_; ++i) turn.apply(R_(k, i), R_(k + 1, i));
    for (int i = 0; i < n_; ++i) turn.apply(J_(i, k), J_(i, k + 1));
  }
}

}  // namespace articam::sim
