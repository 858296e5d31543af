#pragma once
/// @file  A Kalman filter of constant velocity on the configurations: what is known of q and qdot, between the frames
///        and after one.
///
/// The state is (q, qdot), its error the pair of steps that lead from the mean to the truth: model::integrate() for q,
/// a difference for qdot. Between two frames, dt apart, with w the base's angular velocity,
///
///     q' = integrate(q, dt qdot),    e_q' = A e_q + dt e_qdot,    A = exp(dt w) for the rotation, identity elsewhere
///     qdot' = qdot + noise;          of a white acceleration of spectral density s:  s dt^3/3, s dt^2/2, s dt
///
/// A frame measures q alone. Its update is left to the solver, which takes N(q, P_qq) for its prior and gives the
/// configuration q+ and its covariance P+; they carry over to the velocity:
///
///     G = P_vq P_qq^-1,    qdot+ = qdot + G (q+ - q),    P_vq+ = G P+,    P_vv+ = P_vv - G (P_qq - P+) G^T
///
/// Shapes  q, qdot, and the rows and columns of each P: nv.  Units  m, rad, s.
/// Source  Bar-Shalom, Li, Kirubarajan, "Estimation with applications to tracking and navigation", 2001, section 6.2
///         (white-noise acceleration); the update is that of a Kalman filter whose measurement does not see qdot.

#include "core/math/types.hpp"
#include "core/model/configuration.hpp"

namespace articam::tracker {

/// Mean and covariance of a configuration and its velocity.
template <class M, class S>
struct Motion {
  static constexpr int kDof = model::kDof<M>;
  using Square = Mat<S, kDof, kDof>;

  model::Configuration<M, S> q{};
  Vec<S, kDof> qdot = Vec<S, kDof>::Zero();
  Square P_qq = Square::Zero();
  Square P_vq = Square::Zero();  ///< of qdot (rows) with q (columns)
  Square P_vv = Square::Zero();
};

namespace detail {

/// X <- X A^T, where A turns the base's rotation by R and leaves the rest: columns 3 to 5 of X are turned.
template <class S, int N>
void turn_columns(const Mat<S, 3, 3>& R, Mat<S, N, N>& X) noexcept {
  for (int i = 0; i < N; ++i) {
    const S a = X(i, 3), b = X(i, 4), c = X(i, 5);
    for (int k = 0; k < 3; ++k) X(i, 3 + k) = R(k, 0) * a + R(k, 1) * b + R(k, 2) * c;
  }
}
template <class S, int N>
void turn_rows(const Mat<S, 3, 3>& R, Mat<S, N, N>& X) noexcept {
  for (int i = 0; i < N; ++i) {
    const S a = X(3, i), b = X(4, i), c = X(5, i);
    for (int k = 0; k < 3; ++k) X(3 + k, i) = R(k, 0) * a + R(k, 1) * b + R(k, 2) * c;
  }
}

}  // namespace detail

/// The motion dt later (s, not negative), `density` being the acceleration's of each degree of freedom,
/// (m/s^2)^2 / Hz or (rad/s^2)^2 / Hz.
template <class M, class S>
void advance(Motion<M, S>& motion, S dt, const Vec<S, model::kDof<M>>& density) noexcept {
  constexpr int kDof = model::kDof<M>;
  const Vec<S, kDof> step = motion.qdot * dt;
  const Mat<S, 3, 3> R = math::exp_so3<S>(step.template segment<3>(3)).toRotationMatrix();
  motion.q = model::integrate<M, S>(motion.q, step);
  detail::turn_columns<S, kDof>(R, motion.P_qq);
  detail::turn_rows<S, kDof>(R, motion.P_qq);
  detail::turn_columns<S, kDof>(R, motion.P_vq);
  for (int i = 0; i < kDof; ++i) {
    for (int j = 0; j <= i; ++j) {
      const S P_ij = motion.P_qq(i, j) + dt * (motion.P_vq(i, j) + motion.P_vq(j, i) + dt * motion.P_vv(i, j));
      motion.P_qq(i, j) = motion.P_qq(j, i) = P_ij;
    }
  }
  for (int j = 0; j < kDof; ++j) {
    for (int i = 0; i < kDof; ++i) motion.P_vq(i, j) += dt * motion.P_vv(i, j);
    const S q_vv = density[j] * dt;
    motion.P_qq(j, j) += q_vv * dt * dt / S(3);
    motion.P_vq(j, j) += S(0.5) * q_vv * dt;
    motion.P_vv(j, j) += q_vv;
  }
}

/// Takes in what the solver made of a frame: q and its covariance P, its prior having been N(motion.q, P_qq), of which
/// `information` is the inverse.
template <class M, class S>
void correct(Motion<M, S>& motion, const Mat<S, model::kDof<M>, model::kDof<M>>& information,
             const model::Configuration<M, S>& q, const Mat<S, model::kDof<M>, model::kDof<M>>& P) noexcept {
  constexpr int kDof = model::kDof<M>;
  using Square = typename Motion<M, S>::Square;
  const Vec<S, kDof> moved = model::difference<M, S>(motion.q, q);
  const Square G = motion.P_vq.lazyProduct(information), less = motion.P_qq - P;
  const Square G_less = G.lazyProduct(less);
  motion.qdot += G.lazyProduct(moved);
  motion.P_vq = G.lazyProduct(P);
  for (int i = 0; i < kDof; ++i) {
    for (int j = 0; j <= i; ++j) {
      S sum{0};
      for (int k = 0; k < kDof; ++k) sum += G_less(i, k) * G(j, k);
      motion.P_vv(i, j) = motion.P_vv(j, i) = motion.P_vv(i, j) - sum;
    }
  }
  motion.q = q;
  motion.P_qq = P;
}

}  // namespace articam::tracker
