#pragma once
/// @file  One iteration of the solver on given data, and the same as one would write it first.

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <array>

#include "core/tracker/vvs.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "static_models/stress24/stress24.hpp"
#include "tests/support/observe.hpp"

namespace articam::bench {

/// What one iteration is given: 0.3 px of noise, a start that is some millimetres and degrees off.
template <class M, class S>
struct Frame {
  tracker::Matches<M, S> matches;
  tracker::Matches<M, S> whole;  ///< with the shapes of the images, too
  model::Configuration<M, S> q;
  tracker::Prior<M, S> prior;

  explicit Frame(const model::Configuration<M, S>& truth) {
    test::Random random{1};
    matches = whole = test::observe<M, S>(truth, tracker::FeatureKind::imaged_circle, 0.3, &random);
    const auto kinematics = model::forward_kinematics<M, S>(truth.joints);
    for (std::size_t m = 0; m < whole.size(); ++m) {
      const auto circle =
          tracker::circle_in_camera(truth.T_cam_obj, kinematics.markers[m], M::kMarkers[m].outer_diameter_m);
      const Mat<S, 2, 2> shape = vision::imaged_ellipse(circle).value().M;
      whole[m].shape = {shape(0, 0), shape(1, 0), shape(1, 1)};
      whole[m].shape_variance = whole[m].variance;
    }
    q = model::integrate<M, S>(truth, random.vector<S, model::kDof<M>>(-0.02, 0.02));
    prior =
        tracker::independent_prior<M, S>(model::integrate<M, S>(truth, random.vector<S, model::kDof<M>>(-0.01, 0.01)),
                                         Vec<S, model::kDof<M>>::Constant(S(1e-4)));
  }
};

/// The centres of imaged circles, with robust weights.
template <class M, class S>
[[gnu::noinline]] model::Configuration<M, S> iteration(const Frame<M, S>& frame) {
  const auto normal = tracker::linearise(frame.matches, frame.q);
  Vec<S, model::kDof<M>> step;
  const bool ok = normal.status == Status::ok && tracker::damped_step<M, S>(normal, S(0), step) == Status::ok;
  return ok ? model::integrate<M, S>(frame.q, step) : frame.q;
}

/// What the tracker does: the shapes of the images with the marks' common scale, and the prior, too.
template <class M, class S>
[[gnu::noinline]] model::Configuration<M, S> iteration_full(const Frame<M, S>& frame) {
  const auto normal = tracker::linearise(frame.whole, frame.prior, frame.q);
  Vec<S, model::kDof<M>> step;
  const bool ok = normal.status == Status::ok && tracker::damped_step<M, S>(normal, S(0), step) == Status::ok;
  return ok ? model::integrate<M, S>(frame.q, step) : frame.q;
}

/// Plain Eigen: a loop over the table's rows, the points' interaction matrices times a dense Jacobian, A^T A, LDLT, and
/// libm. No weights, no prior. It shares nothing with the solver that it is the measure of.
template <class M>
[[gnu::noinline]] model::Configuration<M, double> generic_iteration(const Frame<M, double>& frame) {
  constexpr int kDof = model::kDof<M>, kMarkers = model::kNumMarkers<M>, kBodies = model::kNumBodies<M>;
  const auto vec = [](const std::array<double, 3>& a) { return Eigen::Vector3d{a[0], a[1], a[2]}; };
  const Eigen::Matrix3d R = frame.q.T_cam_obj.R.toRotationMatrix();
  const Eigen::Vector3d& t = frame.q.T_cam_obj.t;

  std::array<Eigen::Matrix3d, static_cast<std::size_t>(kBodies + 1)> R_body;
  std::array<Eigen::Vector3d, static_cast<std::size_t>(kBodies + 1)> t_body, axis;
  R_body[0] = R, t_body[0] = t;
  for (std::size_t j = 0; j < static_cast<std::size_t>(kBodies); ++j) {
    const auto& row = M::kJoints[j];
    const auto parent = static_cast<std::size_t>(row.parent + 1);
    const auto& [w, x, y, z] = row.r_parent_joint_wxyz;
    const double value = frame.q.joints[model::kValueOfRow<M>[j]];
    const Eigen::Matrix3d R_joint = R_body[parent] * Eigen::Quaterniond{w, x, y, z}.toRotationMatrix();
    const bool slides = row.kind == model::JointKind::prismatic;
    axis[j + 1] = R_joint * vec(row.axis);
    t_body[j + 1] = t_body[parent] + R_body[parent] * vec(row.t_parent_joint_m);
    R_body[j + 1] = R_joint;
    if (slides) t_body[j + 1] += value * axis[j + 1];
    if (!slides) R_body[j + 1] = R_joint * Eigen::AngleAxisd{value, vec(row.axis)}.toRotationMatrix();
  }

  Eigen::Matrix<double, 2 * kMarkers, kDof> A;
  Eigen::Matrix<double, 2 * kMarkers, 1> e;
  for (int m = 0; m < kMarkers; ++m) {
    const auto& row = M::kMarkers[static_cast<std::size_t>(m)];
    const auto body = static_cast<std::size_t>(row.body + 1);
    const Eigen::Vector3d X = t_body[body] + R_body[body] * vec(row.t_body_m);
    const double u = X.x() / X.z(), v = X.y() / X.z(), near = 1 / X.z();
    Eigen::Matrix<double, 2, 3> L;  // of the point's own velocity
    L << near, 0, -u * near, 0, near, -v * near;
    Eigen::Matrix<double, 3, kDof> J = Eigen::Matrix<double, 3, kDof>::Zero();
    J.template leftCols<3>().setIdentity();
    for (int i = 0; i < 3; ++i) J.col(3 + i) = Eigen::Vector3d::Unit(i).cross(X - t);
    for (int j = row.body; j >= 0; j = M::kJoints[static_cast<std::size_t>(j)].parent) {
      const auto i = static_cast<std::size_t>(j);
      const bool slides = M::kJoints[i].kind == model::JointKind::prismatic;
      J.col(6 + model::kValueOfRow<M>[i]) =
          slides ? axis[i + 1] : Eigen::Vector3d{axis[i + 1].cross(X - t_body[i + 1])};
    }
    A.template middleRows<2>(2 * m) = L * J;
    e.template segment<2>(2 * m) = Eigen::Vector2d{u, v} - frame.matches[static_cast<std::size_t>(m)].s_star;
  }
  const Eigen::Matrix<double, kDof, kDof> H = A.transpose() * A;
  const Eigen::Matrix<double, kDof, 1> b = A.transpose() * e;
  const Eigen::Matrix<double, kDof, 1> step = -H.ldlt().solve(b);

  model::Configuration<M, double> moved;
  moved.T_cam_obj.t = t + step.template head<3>();
  const Eigen::Vector3d turn = step.template segment<3>(3);
  const Eigen::Quaterniond R_step{Eigen::AngleAxisd{turn.norm(), turn.normalized()}};
  moved.T_cam_obj.R = (R_step * frame.q.T_cam_obj.R).normalized();
  moved.joints = frame.q.joints + step.template tail<model::kNumJoints<M>>();
  return moved;
}

/// The printer's base with 48 markers on it and on its drawer, where there were 6.
struct Printer48 : models::PrinterDrawer {
  static constexpr auto kMarkers = [] {
    std::array<model::MarkerRow, 48> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i] = models::PrinterDrawer::kMarkers[i % 6];
      rows[i].t_body_m[0] += 0.01 * static_cast<double>(i / 6);
      rows[i].t_body_m[1] -= 0.005 * static_cast<double>(i / 6);
    }
    return rows;
  }();
};
/// 24 joints, four chains of six, with two markers on every body.
struct Chains24x48 : models::Stress24 {
  static constexpr auto kMarkers = [] {
    std::array<model::MarkerRow, 48> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i] = models::Stress24::kMarkers[5 + i / 2];
      rows[i].t_body_m[2] += i % 2 == 0 ? 0.01 : -0.01;
    }
    return rows;
  }();
};

}  // namespace articam::bench
