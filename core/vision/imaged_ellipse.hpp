#pragma once
/// @file  The ellipse that a flat circular mark is seen as, whole: centre and shape, and how both move. Compiled for
///        float and double.

#include "core/math/types.hpp"
#include "core/status.hpp"
#include "core/vision/imaged_circle.hpp"
#include "core/vision/plane_ellipse.hpp"

namespace articam::vision {

/// The circle's image on the metric plane; moving_shape.hpp has the equations. Its centre is imaged_centre().
/// Frames  {cam}.
/// Errors  behind_camera as imaged_centre(); ill_conditioned where there is no ellipse: seen edge on, or of no size.
template <class S>
Result<PlaneEllipse<S>> imaged_ellipse(const Circle<S>& circle) noexcept;

/// An imaged circle, and the interaction matrix of its (x, y, m00, m10, m11).
template <class S>
struct MovingEllipse {
  PlaneEllipse<S> ellipse;
  Mat<S, 5, 6> L;
};

/// The same with its interaction matrix:  sdot = L v, v the twist of the camera relative to the object. The first two
/// rows are imaged_centre_interaction_matrix().
///
/// M as measurements: like the centre they are lengths in which an edge's displacement is linear, so one covariance on
/// the metric plane holds all five and hardly depends on size; and they are smooth where axes and angle are not, at the
/// circle. The entries of M M^T would carry a noise that grows with the size.
/// Shapes, frames, units as interaction_matrix(); errors as imaged_ellipse().
template <class S>
Result<MovingEllipse<S>> moving_ellipse(const Circle<S>& circle) noexcept;

}  // namespace articam::vision
