#include "tools/report/symmetry.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/math/so3.hpp"

namespace articam::report {
namespace {

using modelgen::Table;
using Permutation = std::vector<std::size_t>;

constexpr int kMaxIterations = 12;
const double kMinCosine = std::cos(30 * kDegree);

/// At a share of the limits; `spread` makes the shares of several joints differ.
VectorX joints_at(const Table& table, double share, double spread) {
  const auto n = static_cast<Eigen::Index>(table.values().size());
  const auto golden = [](Eigen::Index j) { return std::fmod(static_cast<double>(j) * 0.618, 1.0); };
  return report::joints_at(table, VectorX::NullaryExpr(n, [&](Eigen::Index j) { return share + spread * golden(j); }));
}

/// {1} as seen from {2}: brings the first mark onto the other, its normal and the direction to a second mark with it.
std::optional<Pose<double>> align(const Marks& from, std::size_t i, std::size_t j, const Marks& to, std::size_t a,
                                  std::size_t b) {
  const auto frame = [](const Marks& marks, std::size_t first, std::size_t second) {
    const Vec3 z = marks.normal[first];
    const Vec3 way = marks.centre[second] - marks.centre[first];
    const Vec3 x = (way - way.dot(z) * z).normalized();
    Eigen::Matrix3d R;
    R << x, z.cross(x), z;
    return R;
  };
  const Eigen::Matrix3d R = frame(to, a, b) * frame(from, i, j).transpose();
  if (!R.allFinite()) return std::nullopt;  // the second mark lies on the first one's normal
  const Quat<double> q(R);
  return Pose<double>{q, to.centre[a] - q * from.centre[i]};
}

class Search {
 public:
  Search(const Table& table, const VectorX& joints)
      : table_{table}, first_{place_marks(table, joints)}, joints_{joints} {
    for (std::size_t m = 0; m < table.markers.size(); ++m) {
      if (is_mark(table.markers[m])) marks_.push_back(m);
    }
    for (const std::size_t m : marks_) {
      for (const std::size_t k : marks_) extent_m_ = std::max(extent_m_, (first_.centre[m] - first_.centre[k]).norm());
    }
  }

  std::vector<Symmetry> run(Says says) {
    if (marks_.size() < 2) return {};
    const auto [i, j] = widest_pair();
    const std::vector<VectorX> all = guesses();
    for (const VectorX& guess : all) {
      says("look-alikes", static_cast<double>(&guess - all.data()) / static_cast<double>(all.size()));
      const Marks second = place_marks(table_, guess);
      for (const std::size_t a : marks_) {
        for (const std::size_t b : marks_) {
          if (a == b || !alike(i, a) || !alike(j, b)) continue;
          const auto T = align(first_, i, j, second, a, b);
          if (T) refine(*T, guess);
          if (found_.size() == kMaxSymmetries) return found_;
        }
      }
    }
    return found_;
  }

 private:
  /// Where the second configuration is sought: here and there in the limits, and a whole turn of a joint away.
  std::vector<VectorX> guesses() const {
    std::vector<VectorX> all{joints_, report::joints_at(table_, 0), report::joints_at(table_, 0.5),
                             report::joints_at(table_, 1), joints_at(table_, 0.9, -0.8)};
    const auto values = table_.values();
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (values[j]->kind != model::JointKind::revolute) continue;
      for (const double turn : {-2 * std::numbers::pi, 2 * std::numbers::pi}) {
        VectorX turned = joints_;
        turned[static_cast<Eigen::Index>(j)] += turn;
        const double value = turned[static_cast<Eigen::Index>(j)];
        if (value >= low_limit(*values[j]) && value <= high_limit(*values[j])) all.push_back(turned);
      }
    }
    return all;
  }

  bool alike(std::size_t m, std::size_t k) const {
    const auto &a = table_.markers[m], &b = table_.markers[k];
    return a.kind == b.kind && a.outer_diameter_m == b.outer_diameter_m && a.inner_diameter_m == b.inner_diameter_m;
  }

  /// Of one body if it has two marks: their distance is then the same in every configuration.
  std::pair<std::size_t, std::size_t> widest_pair() const {
    std::pair<std::size_t, std::size_t> widest{marks_[0], marks_[1]};
    double most = -1;
    for (const std::size_t m : marks_) {
      for (const std::size_t k : marks_) {
        const bool same_body = table_.markers[m].body == table_.markers[k].body;
        const double distance = (first_.centre[m] - first_.centre[k]).norm() + (same_body ? extent_m_ : 0);
        if (m != k && distance > most) most = distance, widest = {m, k};
      }
    }
    return widest;
  }

  /// Every mark to the nearest free one that is alike and faces the same way; nothing where one finds none.
  std::optional<Permutation> assign(const Pose<double>& T, const Marks& second) const {
    Permutation to(table_.markers.size());
    std::iota(to.begin(), to.end(), 0);
    std::vector<bool> taken(table_.markers.size());
    for (const std::size_t m : marks_) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const std::size_t k : marks_) {
        const double distance = (T * first_.centre[m] - second.centre[k]).norm();
        const bool faces = (T.R * first_.normal[m]).dot(second.normal[k]) > kMinCosine;
        if (taken[k] || !alike(m, k) || !faces || distance >= nearest) continue;
        nearest = distance;
        to[m] = k;
      }
      if (!std::isfinite(nearest)) return std::nullopt;
      taken[to[m]] = true;
    }
    return to;
  }

  double largest_distance(const Pose<double>& T, const Marks& second, const Permutation& to) const {
    double most = 0;
    for (const std::size_t m : marks_) {
      most = std::max(most, (T * first_.centre[m] - second.centre[to[m]]).norm());
    }
    return most;
  }

  struct Normal {
    MatrixX H;
    VectorX g;
  };

  /// Of the distances of marks that should coincide; the unknowns are the rigid motion and the second joint values.
  Normal normal_equations(const Permutation& to, const Marks& second, const Pose<double>& T) const {
    const Eigen::Index joints = joints_.size(), n = 6 + joints;
    Normal normal{1e-9 * MatrixX::Identity(n, n), VectorX::Zero(n)};
    for (const std::size_t m : marks_) {
      const Vec3 arm = T.R * first_.centre[m];
      const Vec3 e = arm + T.t - second.centre[to[m]];
      Eigen::Matrix<double, 3, Eigen::Dynamic> J(3, n);
      J.leftCols<3>().setIdentity();
      J.middleCols<3>(3) = -math::hat<double>(arm);
      J.rightCols(joints) = -second.velocity[to[m]];
      normal.H += J.transpose() * J;
      normal.g += J.transpose() * e;
    }
    return normal;
  }

  /// One Gauss-Newton step of the rigid motion and the second joint values.
  void step(const Permutation& to, const Marks& second, Pose<double>& T, VectorX& joints) const {
    const Normal normal = normal_equations(to, second, T);
    const VectorX d = normal.H.ldlt().solve(-normal.g);
    T.t += d.head<3>();
    T.R = (math::exp_so3<double>(Vec3(d.segment<3>(3))) * T.R).normalized();
    joints =
        (joints + d.tail(joints.size())).cwiseMax(report::joints_at(table_, 0)).cwiseMin(report::joints_at(table_, 1));
  }

  void refine(Pose<double> T, VectorX joints) {
    Marks second = place_marks(table_, joints);
    auto to = assign(T, second);
    for (int i = 0; i < kMaxIterations && to; ++i) {
      step(*to, second, T, joints);
      second = place_marks(table_, joints);
      to = assign(T, second);
    }
    if (!to) return;
    const double residual_m = largest_distance(T, second, *to);
    Symmetry found{*to, joints_, joints, math::log_so3<double>(T.R), residual_m};
    if (residual_m > kCoincidence * extent_m_ || is_known(found)) return;
    if (!found.needs_identities() && (is_where_it_was(T, joints) || !is_isolated(*to, T, second))) return;
    found_.push_back(found);
  }

  /// The first configuration again: a joint that turns without limits comes back after a whole turn.
  bool is_where_it_was(const Pose<double>& T, const VectorX& joints) const {
    constexpr double kNear = 1e-3;  // m or rad
    const auto values = table_.values();
    double most = std::max(T.t.norm(), math::log_so3<double>(T.R).norm());
    for (std::size_t j = 0; j < values.size(); ++j) {
      double way = std::abs(joints[static_cast<Eigen::Index>(j)] - joints_[static_cast<Eigen::Index>(j)]);
      if (values[j]->kind == model::JointKind::continuous) way = std::abs(std::remainder(way, 2 * std::numbers::pi));
      most = std::max(most, way);
    }
    return most < kNear;
  }

  /// Whether the second configuration is one of its own, and not one of a family along which no mark moves.
  bool is_isolated(const Permutation& to, const Pose<double>& T, const Marks& second) const {
    constexpr double kMoves_m2 = 1e-7;  // squared, of all marks per rad: a third of a millimetre
    const Normal normal = normal_equations(to, second, T);
    if (normal.H.diagonal().minCoeff() < kMoves_m2) return false;
    const VectorX scale = normal.H.diagonal().cwiseSqrt().cwiseInverse();
    const MatrixX scaled = scale.asDiagonal() * normal.H * scale.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<MatrixX>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0] > 1e-5;
  }

  bool is_known(const Symmetry& found) const {
    return std::any_of(found_.begin(), found_.end(), [&](const Symmetry& s) {
      return s.takes_place_of == found.takes_place_of &&
             (found.needs_identities() || (s.other_joints - found.other_joints).norm() < 1e-3);
    });
  }

  const Table& table_;
  Marks first_;
  VectorX joints_;
  std::vector<std::size_t> marks_;
  double extent_m_{};
  std::vector<Symmetry> found_;
};

}  // namespace

bool Symmetry::needs_identities() const {
  for (std::size_t m = 0; m < takes_place_of.size(); ++m) {
    if (takes_place_of[m] != m) return true;
  }
  return false;
}

std::vector<Symmetry> find_symmetries(const Table& table, Says says) {
  std::vector<Symmetry> all = Search(table, joints_at(table, 0.3, 0.4)).run(says);
  if (table.values().empty()) return all;
  for (const Symmetry& closed : Search(table, report::joints_at(table, 0)).run(says)) {
    const auto same = [&](const Symmetry& s) {
      return closed.needs_identities() && s.takes_place_of == closed.takes_place_of;
    };
    if (std::none_of(all.begin(), all.end(), same)) all.push_back(closed);
  }
  return all;
}

}  // namespace articam::report
