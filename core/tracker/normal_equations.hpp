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
/// Work    multiplications and additions, each 1: about 155 a mark, 45 a sliding joint, 120 a turning one and 11 for
///         each joint above it.
/// Source  Featherstone, "Rigid body dynamics algorithms", 2008, section 6.2: the composite-rigid-body algorithm, with
///         information in the place of inertia.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/model/body_places.hpp"
#include "core/model/joint_paths.hpp"
#include "core/tracker/associate.hpp"
#include "core/tracker/body_information.hpp"
#include "core/tracker/mark_order.hpp"
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
    if constexpr (!Order::kIsChain) normal_.H.entries = {}, normal_.b = {};
    normal_.scale = {};
    S shape_variances{0};
    for (const Match<S>& match : matches) shape_variances += match.shape_variance;
    has_shapes_ = kind != FeatureKind::point && shape_variances > S(0);
    model::BodyPlaces<M, S> places;
    model::place_bodies<M, S>(math::axes_of(R.w(), R.x(), R.y(), R.z()), q.joints, places);
    const Frame frame{matches, places, q.T_cam_obj.t, kind};
    place_marks(frame, std::make_index_sequence<M::kMarkers.size()>{});
    if (!add_bodies(frame, std::make_index_sequence<kNumBodies + 1>{})) return Status::behind_camera;
    put_base(sums_[Order::kSlot[0]]);
    normal_.cost = misfit_.cost() + shape_misfit_.cost();
    normal_.chi2 = misfit_.chi2;
    normal_.shape_chi2 = shape_misfit_.chi2;
    if (scale_.information > S(0)) eliminate_scale();
    normal_.error2 = misfit_.error2;
    return Status::ok;
  }

 private:
  static constexpr std::size_t kNumBodies = M::kJoints.size();
  using Order = MarkOrder<M>;
  struct Frame {
    const Matches<M, S>& matches;
    const model::BodyPlaces<M, S>& places;
    const Vec<S, 3>& t_cam_obj;
    FeatureKind kind;
  };

  /// All of them before the first is added: the bodies' axes need not be kept through that.
  template <std::size_t... n>
  [[gnu::always_inline]] void place_marks(const Frame& frame, std::index_sequence<n...>) noexcept {
    (place_mark<n, Order::kSorted[n]>(frame), ...);
  }
  template <std::size_t n, std::size_t kMarker>
  [[gnu::always_inline]] void place_mark(const Frame& frame) noexcept {
    constexpr const model::MarkerRow& row = M::kMarkers[kMarker];
    marks_[n].arm = place_point(frame.places[row.body + 1], row.body < 0, row.t_body_m);
    marks_[n].match = &frame.matches[kMarker];
  }
  /// From the last body to the root.
  template <std::size_t... n>
  [[gnu::always_inline]] bool add_bodies(const Frame& frame, std::index_sequence<n...>) noexcept {
    return (add_body<static_cast<int>(kNumBodies - n) - 1>(frame) && ...);
  }
  template <int kBody>
  [[gnu::always_inline]] bool add_body(const Frame& frame) noexcept {
    const bool in_front = add_markers<kBody>(frame, std::make_index_sequence<Order::kNumGroups>{});
    if constexpr (kBody >= 0) add_joint<kBody>(frame, std::make_index_sequence<kNumBodies>{});
    return in_front;
  }

  template <int kBody, std::size_t... kGroup>
  [[gnu::always_inline]] bool add_markers(const Frame& frame, std::index_sequence<kGroup...>) noexcept {
    return (add_group<kBody, kGroup>(frame) && ...);
  }
  template <int kBody, std::size_t kGroup>
  [[gnu::always_inline]] bool add_group(const Frame& frame) noexcept {
    constexpr const typename Order::Group& group = Order::kGroups[kGroup];
    if constexpr (group.body != kBody) return true;
    if constexpr (group.turns) turn_plate<kGroup>(frame);
    const PlacedMark<S>* marks = &marks_[group.begin];
    BodyInformation<S>& sum = sums_[Order::kSlot[kBody + 1]];
    const auto& t = frame.t_cam_obj;
    return Status::ok == (has_shapes_
                              ? add_whole_marks(marks, group.size, plate_, t, sum, misfit_, shape_misfit_, scale_)
                              : add_centres(marks, group.size, plate_, t, sum, misfit_));
  }
  template <std::size_t kGroup>
  [[gnu::always_inline]] void turn_plate(const Frame& frame) noexcept {
    constexpr const typename Order::Facing& facing = Order::kGroups[kGroup].facing;
    const S radius = frame.kind == FeatureKind::point ? S(0) : static_cast<S>(0.5 * facing.diameter_m) * (S(1) + u_);
    plate_ = {along(frame.places[facing.body + 1].axes, facing.normal), radius};
  }
  template <int kBody, std::size_t... kOther>
  [[gnu::always_inline]] void add_joint(const Frame& frame, std::index_sequence<kOther...>) noexcept {
    constexpr const model::JointRow& row = M::kJoints[kBody];
    constexpr int kUnknown = 6 + model::kValueOfRow<M>[kBody];
    constexpr S kRatio = static_cast<S>(row.ratio);
    const BodyInformation<S>& sum = sums_[Order::kSlot[kBody + 1]];
    const auto& [linear, angular] = frame.places[kBody + 1].motion;
    Wrench<S> common;
    S gradient = dot(sum.pull.force, linear);
    if constexpr (row.kind == model::JointKind::prismatic) {
      common = of_slide(sum, linear);
    } else {
      common = of_turn(sum, linear, angular);
      gradient += dot(sum.pull.torque, angular);
    }
    if constexpr (row.ratio != 1) {
      common = {kRatio * common.force, kRatio * common.torque};
      gradient *= kRatio;
    }
    put(normal_.b[kUnknown], gradient);
    if (has_shapes_) {
      S with_scale = dot(sum.scale.force, linear);
      if constexpr (row.kind != model::JointKind::prismatic) with_scale += dot(sum.scale.torque, angular);
      normal_.scale.with[kUnknown] += kRatio * with_scale;
    }
    put(normal_.H.at(kUnknown, 0), common.force.x);
    put(normal_.H.at(kUnknown, 1), common.force.y);
    put(normal_.H.at(kUnknown, 2), common.force.z);
    put(normal_.H.at(kUnknown, 3), common.torque.x);
    put(normal_.H.at(kUnknown, 4), common.torque.y);
    put(normal_.H.at(kUnknown, 5), common.torque.z);
    (add_common<kBody, static_cast<int>(kOther)>(common, frame.places[kOther + 1].motion), ...);
    if constexpr (constexpr int parent = row.parent; Order::kSlot[kBody + 1] != Order::kSlot[parent + 1])
      sums_[Order::kSlot[parent + 1]] += sum;
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
    if constexpr (Order::kHasMimics) {
      entry += part;
    } else {
      entry = part;
    }
  }

  void put_base(const BodyInformation<S>& sum) noexcept {
    std::copy(sum.H.entries.begin(), sum.H.entries.end(), normal_.H.entries.begin());  // the first six rows
    const auto& [force, torque] = sum.pull;
    normal_.b[0] = force.x, normal_.b[1] = force.y, normal_.b[2] = force.z;
    normal_.b[3] = torque.x, normal_.b[4] = torque.y, normal_.b[5] = torque.z;
    if (!has_shapes_) return;
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
    const S v = variance = S(1) / (scale_.information * per_u * per_u + kCertainty);
    const S p = pull = scale_.pull * per_u - kCertainty * u_;
    S* entry = normal_.H.entries.data();  // row by row, from the diagonal to the first column
    for (std::size_t i = 0; i < with.size(); ++i) {
      with[i] *= per_u;
      const S share = v * with[i];
      normal_.b[i] -= share * p;
      for (std::size_t j = i + 1; j-- > 0;) *entry++ -= share * with[j];
    }
    normal_.cost += S(0.5) * kCertainty * u_ * u_;
  }

  std::array<BodyInformation<S>, Order::kNumSlots> sums_{};
  Misfit<S> misfit_{}, shape_misfit_{};
  ScaleInformation<S> scale_{};
  std::array<PlacedMark<S>, Order::kNumMarkers> marks_;  ///< as Order::kSorted
  vision::Plate<S> plate_;                               ///< of the marks being added
  S u_;
  bool has_shapes_{};
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
