#pragma once
/// @file  Matches and a configuration -> the normal equations of one step, unrolled over the model's table.
///
/// Every body's twist is taken at {obj}'s origin, along the axes of {cam}; there the base's is (dt, dr) itself. From
/// the last body to the root, the marks of a body and of the bodies behind it add up to H_b, b_b, and its joint, which
/// moves all of them with the twist m per unit, has
///
///     H(joint, base) = H_b m,   H(joint, ancestor) = m_a . H_b m,   H(joint, joint) = m . H_b m,   b(joint) = m . b_b
///
/// and what arrives at the root is the base's. The dense A is never built: a mark costs the same whatever the number of
/// joints, and a joint the same whatever the number of marks.
///
/// Work    multiplications and additions, each 1: about 165 a mark, 45 a sliding joint, 120 a turning one and 11 for
///         each joint above it.
/// Source  Featherstone, "Rigid body dynamics algorithms", 2008, section 6.2: the composite-rigid-body algorithm, with
///         information in the place of inertia.

#include <array>
#include <cstddef>
#include <utility>

#include "core/model/body_places.hpp"
#include "core/model/joint_paths.hpp"
#include "core/tracker/associate.hpp"
#include "core/tracker/body_information.hpp"
#include "core/tracker/normal.hpp"
#include "core/tracker/shape_information.hpp"

namespace articam::tracker {

/// What linearise() is made of.
template <class M, class S>
class Linearisation {
 public:
  Linearisation(S scale, Normal<M, S>& normal) noexcept : u_{scale}, normal_{normal} {}

  [[gnu::always_inline]] Status add_matches(const Matches<M, S>& matches, const model::Configuration<M, S>& q,
                                            FeatureKind kind) noexcept {
    const Quat<S>& R = q.T_cam_obj.R;
    normal_.H.entries = {}, normal_.b = {}, normal_.scale = {};  // joints that share no mark leave entries at 0
    model::BodyPlaces<M, S> places;
    model::place_bodies<M, S>(math::axes_of(R.w(), R.x(), R.y(), R.z()), q.joints, places);
    const math::Triple<S> t_cam_obj = math::to_triple(q.T_cam_obj.t);
    const Frame frame{matches, places, t_cam_obj, kind};
    if (!add_bodies(frame, std::make_index_sequence<kNumBodies + 1>{})) return Status::behind_camera;
    put_base(sums_[kSlot[0]]);
    normal_.cost = misfit_.cost() + shape_misfit_.cost();
    normal_.chi2 = misfit_.chi2;
    normal_.shape_chi2 = shape_misfit_.chi2;
    if (scale_.information > S(0)) eliminate_scale();
    normal_.error2 = misfit_.error2;
    return Status::ok;
  }

 private:
  static constexpr std::size_t kNumBodies = M::kJoints.size();
  static constexpr bool kHasMimics = model::kNumBodies<M> != model::kNumJoints<M>;
  struct Frame {
    const Matches<M, S>& matches;
    const model::BodyPlaces<M, S>& places;
    const math::Triple<S>& t_cam_obj;
    FeatureKind kind;
  };

  /// kSlot[body + 1]: which sum collects the body's marks. A body goes on with the sum of its last child, which is
  /// done with when the body's turn comes; so a chain needs one sum.
  static constexpr auto kSlot = [] {
    std::array<std::size_t, kNumBodies + 1> slot{};
    std::array<bool, kNumBodies + 1> begun{};
    std::size_t next = 0;
    for (std::size_t b = kNumBodies + 1; b-- > 0;) {
      if (!begun[b]) slot[b] = next++;
      if (b == 0) break;
      const auto parent = static_cast<std::size_t>(M::kJoints[b - 1].parent + 1);
      if (!begun[parent]) slot[parent] = slot[b], begun[parent] = true;
    }
    return slot;
  }();
  static constexpr std::size_t kNumSlots = [] {
    std::size_t most = 0;
    for (const std::size_t slot : kSlot) most = slot > most ? slot : most;
    return most + 1;
  }();

  /// Whether two markers are alike but for their places.
  static constexpr bool together(const model::MarkerRow& a, const model::MarkerRow& b) noexcept {
    return a.body == b.body && a.normal == b.normal && a.outer_diameter_m == b.outer_diameter_m;
  }
  /// kIsFirst[m]: no marker before m is like it.
  static constexpr auto kIsFirst = [] {
    std::array<bool, M::kMarkers.size()> first{};
    for (std::size_t m = 0; m < first.size(); ++m) {
      first[m] = true;
      for (std::size_t other = 0; other < m; ++other) first[m] &= !together(M::kMarkers[m], M::kMarkers[other]);
    }
    return first;
  }();
  static constexpr std::size_t count_with(std::size_t m) noexcept {
    std::size_t n = 0;
    for (const model::MarkerRow& row : M::kMarkers) n += together(row, M::kMarkers[m]) ? 1 : 0;
    return n;
  }
  /// From the last body to the root.
  template <std::size_t... n>
  [[gnu::always_inline]] bool add_bodies(const Frame& frame, std::index_sequence<n...>) noexcept {
    return (add_body<static_cast<int>(kNumBodies - n) - 1>(frame) && ...);
  }
  template <int kBody>
  [[gnu::always_inline]] bool add_body(const Frame& frame) noexcept {
    const bool in_front = add_markers<kBody>(frame, std::make_index_sequence<M::kMarkers.size()>{});
    if constexpr (kBody >= 0) add_joint<kBody>(frame, std::make_index_sequence<kNumBodies>{});
    return in_front;
  }

  template <int kBody, std::size_t... kMarker>
  [[gnu::always_inline]] bool add_markers(const Frame& frame, std::index_sequence<kMarker...> all) noexcept {
    return (add_like<kBody, kMarker>(frame, all) && ...);
  }
  /// The markers like kFirst, which have normal and radius in common.
  template <int kBody, std::size_t kFirst, std::size_t... kMarker>
  [[gnu::always_inline]] bool add_like(const Frame& frame, std::index_sequence<kMarker...>) noexcept {
    if constexpr (constexpr const model::MarkerRow& row = M::kMarkers[kFirst]; row.body == kBody && kIsFirst[kFirst]) {
      std::array<PlacedMark<S>, count_with(kFirst)> marks;
      PlacedMark<S>* next = marks.data();
      ((next = place<kFirst, kMarker>(frame, next)), ...);
      const S radius =
          frame.kind == FeatureKind::point ? S(0) : static_cast<S>(0.5 * row.outer_diameter_m) * (S(1) + u_);
      const math::Triple<S> normal = along(frame.places[kBody + 1].axes, row.normal);
      BodyInformation<S>& sum = sums_[kSlot[kBody + 1]];
      if (add_centres(marks.data(), marks.size(), normal, radius, frame.t_cam_obj, sum, misfit_) != Status::ok)
        return false;
      return radius > S(0) ? add_shapes(marks.data(), marks.size(), normal, radius, frame.t_cam_obj, sum) : true;
    }
    return true;
  }
  bool add_shapes(const PlacedMark<S>* marks, std::size_t num_marks, const math::Triple<S>& normal, S radius,
                  const math::Triple<S>& t, BodyInformation<S>& sum) noexcept {
    for (const PlacedMark<S>* mark = marks; mark != marks + num_marks; ++mark) {
      if (!mark->match->matched || !(mark->match->shape_variance > S(0))) continue;
      const vision::Circle<S> circle{to_vec(t + mark->arm), to_vec(normal), radius};
      // Edge on it has no shape, and says nothing.
      const Status status = add_shape(circle, mark->arm, *mark->match, sum, shape_misfit_, scale_);
      if (status != Status::ok && status != Status::ill_conditioned) return false;
    }
    return true;
  }
  template <std::size_t kFirst, std::size_t kMarker>
  [[gnu::always_inline]] PlacedMark<S>* place(const Frame& frame, PlacedMark<S>* next) noexcept {
    constexpr const model::MarkerRow& row = M::kMarkers[kMarker];
    if constexpr (!together(row, M::kMarkers[kFirst])) return next;
    next->arm = place_point(frame.places[row.body + 1], row.body < 0, row.t_body_m);
    next->match = &frame.matches[kMarker];
    return next + 1;
  }

  template <int kBody, std::size_t... kOther>
  [[gnu::always_inline]] void add_joint(const Frame& frame, std::index_sequence<kOther...>) noexcept {
    constexpr const model::JointRow& row = M::kJoints[kBody];
    constexpr int kUnknown = 6 + model::kValueOfRow<M>[kBody];
    constexpr S kRatio = static_cast<S>(row.ratio);
    const BodyInformation<S>& sum = sums_[kSlot[kBody + 1]];
    const auto& [linear, angular] = frame.places[kBody + 1].motion;
    Wrench<S> common;
    S gradient = dot(sum.pull.force, linear), with_scale = dot(sum.scale.force, linear);
    if constexpr (row.kind == model::JointKind::prismatic) {
      common = of_slide(sum, linear);
    } else {
      common = of_turn(sum, linear, angular);
      gradient += dot(sum.pull.torque, angular);
      with_scale += dot(sum.scale.torque, angular);
    }
    if constexpr (row.ratio != 1) {
      common = {kRatio * common.force, kRatio * common.torque};
      gradient *= kRatio, with_scale *= kRatio;
    }
    put(normal_.b[kUnknown], gradient);
    put(normal_.scale.with[kUnknown], with_scale);
    put(normal_.H.at(kUnknown, 0), common.force.x);
    put(normal_.H.at(kUnknown, 1), common.force.y);
    put(normal_.H.at(kUnknown, 2), common.force.z);
    put(normal_.H.at(kUnknown, 3), common.torque.x);
    put(normal_.H.at(kUnknown, 4), common.torque.y);
    put(normal_.H.at(kUnknown, 5), common.torque.z);
    (add_common<kBody, static_cast<int>(kOther)>(common, frame.places[kOther + 1].motion), ...);
    if constexpr (constexpr int parent = row.parent; kSlot[kBody + 1] != kSlot[parent + 1])
      sums_[kSlot[parent + 1]] += sum;
  }

  /// What a joint has in common with one on its way to the root, itself included.
  template <int kBody, int kOther>
  [[gnu::always_inline]] void add_common(const Wrench<S>& common, const model::JointMotion<S>& motion) noexcept {
    constexpr int kThis = 6 + model::kValueOfRow<M>[kBody], kThat = 6 + model::kValueOfRow<M>[kOther];
    constexpr int kRow = kThis > kThat ? kThis : kThat, kColumn = kThis > kThat ? kThat : kThis;
    if constexpr (model::moves<M>(kOther, kBody)) {
      constexpr const model::JointRow& other = M::kJoints[kOther];
      S entry = dot(common.force, motion.linear);
      if constexpr (other.kind != model::JointKind::prismatic) entry += dot(common.torque, motion.angular);
      if constexpr (other.ratio != 1) entry *= static_cast<S>(other.ratio);
      if constexpr (kBody != kOther && kRow == kColumn) entry *= S(2);  // two joints that one value moves
      put(normal_.H.at(kRow, kColumn), entry);
    }
  }

  /// Only where a joint mimics another does an entry have several parts.
  [[gnu::always_inline]] static void put(S& entry, S part) noexcept {
    if constexpr (kHasMimics) {
      entry += part;
    } else {
      entry = part;
    }
  }

  void put_base(const BodyInformation<S>& sum) noexcept {
    auto& H = normal_.H;
    const auto& [x, y, z] = sum.vw;
    H.at(0, 0) = sum.vv.xx;
    H.at(1, 0) = sum.vv.xy, H.at(1, 1) = sum.vv.yy;
    H.at(2, 0) = sum.vv.xz, H.at(2, 1) = sum.vv.yz, H.at(2, 2) = sum.vv.zz;
    H.at(3, 0) = x.x, H.at(3, 1) = y.x, H.at(3, 2) = z.x, H.at(3, 3) = sum.ww.xx;
    H.at(4, 0) = x.y, H.at(4, 1) = y.y, H.at(4, 2) = z.y, H.at(4, 3) = sum.ww.xy, H.at(4, 4) = sum.ww.yy;
    H.at(5, 0) = x.z, H.at(5, 1) = y.z, H.at(5, 2) = z.z;
    H.at(5, 3) = sum.ww.xz, H.at(5, 4) = sum.ww.yz, H.at(5, 5) = sum.ww.zz;
    const auto& [force, torque] = sum.pull;
    normal_.b[0] = force.x, normal_.b[1] = force.y, normal_.b[2] = force.z;
    normal_.b[3] = torque.x, normal_.b[4] = torque.y, normal_.b[5] = torque.z;
    const auto& [with_v, with_w] = sum.scale;
    auto& with = normal_.scale.with;
    with[0] = with_v.x, with[1] = with_v.y, with[2] = with_v.z;
    with[3] = with_w.x, with[4] = with_w.y, with[5] = with_w.z;
  }

  /// Schur's complement: the scale steps with the rest, see EliminatedScale::step_of().
  void eliminate_scale() noexcept {
    constexpr S kCertainty = S(1) / (kPrintScale<S> * kPrintScale<S>);
    const S per_u = S(1) / (S(1) + u_);  // of the logarithm, for which add_shape() has the derivative
    auto& [variance, pull, with] = normal_.scale;
    variance = S(1) / (scale_.information * per_u * per_u + kCertainty);
    pull = scale_.pull * per_u - kCertainty * u_;
    for (S& share : with) share *= per_u;
    for (int i = 0; i < model::kDof<M>; ++i) {
      const S share = variance * with[static_cast<std::size_t>(i)];
      normal_.b[static_cast<std::size_t>(i)] -= share * pull;
      for (int j = 0; j <= i; ++j) normal_.H.at(i, j) -= share * with[static_cast<std::size_t>(j)];
    }
    normal_.cost += S(0.5) * kCertainty * u_ * u_;
  }

  std::array<BodyInformation<S>, kNumSlots> sums_{};
  Misfit<S> misfit_{}, shape_misfit_{};
  ScaleInformation<S> scale_{};
  S u_;
  Normal<M, S>& normal_;
};

/// H = A^T W A and b = -A^T W e, with Huber weights of the 2-D distances inside W; the marks are taken for
/// larger by `scale`, relative.
/// Normal::status is behind_camera when a matched marker is not in front of the camera; the rest is then not set.
template <class M, class S>
Normal<M, S> linearise(const Matches<M, S>& matches, const model::Configuration<M, S>& q,
                       FeatureKind kind = FeatureKind::imaged_circle, S scale = S(0)) noexcept {
  Normal<M, S> normal;
  normal.status = Linearisation<M, S>{scale, normal}.add_matches(matches, q, kind);
  return normal;
}

}  // namespace articam::tracker
