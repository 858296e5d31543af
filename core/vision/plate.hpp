#pragma once
/// @file  What flat circular marks have in common that face one way.

#include "core/math/triple.hpp"
#include "core/vision/interaction_matrix.hpp"

namespace articam::vision {

/// What circles have in common that are of one size and face one way, along the axes of {cam}: the terms of
/// imaged_centre(). Either side of them may be the front.
template <class S>
struct Plate {
  Plate() noexcept = default;
  Plate(const math::Triple<S>& normal, S radius_m) noexcept
      : n{normal},
        r{radius_m},
        rn{(r * r) * n},
        at_pole{rn.z * n},
        N_z{at_pole.z - r * r},
        nearest{r > S(kMinDepth_m) ? r : S(kMinDepth_m)} {}

  math::Triple<S> n;            ///< unit normal
  S r;                          ///< radius, m
  math::Triple<S> rn, at_pole;  ///< r^2 n and r^2 n_z n
  S N_z;                        ///< r^2 (n_z^2 - 1): M is  c c_z + (at_pole_x, at_pole_y, N_z)
  S nearest;                    ///< that a centre may come, m
};

}  // namespace articam::vision
