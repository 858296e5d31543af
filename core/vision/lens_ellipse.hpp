#pragma once
/// @file  An ellipse on the metric plane <-> the ellipse that fits its image through the lens best.
///
/// A lens bends an ellipse into a curve that is none, and moves it: the image of its centre is up to 4.5 px off for a
/// mark of 72 px in the corner of a wide lens. What a detector reports is the ellipse whose radial offsets to the
/// curve, in units of the local radius and along rays even in the ellipse's own angle, have no mean and no first or
/// second harmonic; other least squares put the centre within 0.002 px of that. Both directions here meet exactly it,
/// at kPoints points of the curve with their slopes (within 1e-6 px); a lens that does not distort costs one affine
/// map. Compiled for float and double.

#include "core/math/types.hpp"
#include "core/status.hpp"
#include "core/vision/camera_model.hpp"
#include "core/vision/detection.hpp"
#include "core/vision/plane_ellipse.hpp"

namespace articam::vision {

/// The ellipse in pixels that fits the image of an ellipse on the metric plane Z = 1 best.
/// Errors  outside_domain when a part of its edge lies outside the lens model's domain; ill_conditioned when its image
///         is far from any ellipse.
template <class S>
Result<PlaneEllipse<S>> distorted_ellipse(const PlaneEllipse<S>& on_plane, const CameraModel<S>& camera) noexcept;

/// The inverse: the ellipse on the metric plane whose image `in_pixels` fits best.
/// Errors  bad_argument when it is empty or not a number; else as distorted_ellipse().
template <class S>
Result<PlaneEllipse<S>> undistorted_ellipse(const PlaneEllipse<S>& in_pixels, const CameraModel<S>& camera) noexcept;

/// The same from a detection's ellipse.
template <class S>
Result<PlaneEllipse<S>> undistorted_ellipse(const Ellipse& image, const CameraModel<S>& camera) noexcept;

}  // namespace articam::vision
