#pragma once
/// @file  Three numbers and a frame's axes as plain aggregates, and their products with constants of a table.
///
/// Eigen's types stay where a user sees them. Inside the solver they would cost each model seconds of compile time for
/// their expressions, and a product with a 0 that only the table knows would still be computed.

#include <array>

#include "core/math/types.hpp"

namespace articam::math {

template <class S>
struct Triple {
  S x, y, z;

  constexpr Triple& operator+=(const Triple& b) noexcept {
    x += b.x, y += b.y, z += b.z;
    return *this;
  }
  friend constexpr Triple operator+(const Triple& a, const Triple& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Triple operator-(const Triple& a, const Triple& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Triple operator-(const Triple& a) noexcept { return {-a.x, -a.y, -a.z}; }
  friend constexpr Triple operator*(S c, const Triple& a) noexcept { return {c * a.x, c * a.y, c * a.z}; }
};

template <class S>
constexpr S dot(const Triple<S>& a, const Triple<S>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S>
constexpr Triple<S> cross(const Triple<S>& a, const Triple<S>& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class S>
constexpr Triple<S> to_triple(const Vec<S, 3>& v) noexcept {
  return {v[0], v[1], v[2]};
}
template <class S>
Vec<S, 3> to_vec(const Triple<S>& a) noexcept {
  return {a.x, a.y, a.z};
}

/// The axes of a frame, written in another: the columns of the rotation between them.
template <class S>
struct Axes {
  Triple<S> x, y, z;

  friend constexpr Triple<S> operator*(const Axes& R, const Triple<S>& p) noexcept {
    return p.x * R.x + p.y * R.y + p.z * R.z;
  }
};

template <class S>
inline constexpr Axes<S> kSameAxes{{S(1), S(0), S(0)}, {S(0), S(1), S(0)}, {S(0), S(0), S(1)}};

/// The rotation of a unit quaternion.
template <class S>
constexpr Axes<S> axes_of(S w, S x, S y, S z) noexcept {
  const S x2 = x + x, y2 = y + y, z2 = z + z;
  const S xx = x * x2, yy = y * y2, zz = z * z2, xy = x * y2, xz = x * z2, yz = y * z2;
  const S wx = w * x2, wy = w * y2, wz = w * z2;
  return {
      {S(1) - (yy + zz), xy + wz, xz - wy}, {xy - wz, S(1) - (xx + zz), yz + wx}, {xz + wy, yz - wx, S(1) - (xx + yy)}};
}

namespace detail {

/// sum + c a, where `any` tells whether sum is more than nothing yet.
template <class S>
[[gnu::always_inline]] constexpr void add_part(Triple<S>& sum, bool& any, double c, const Triple<S>& a) noexcept {
  if (c == 0) return;
  const Triple<S> part = c == 1 ? a : c == -1 ? -a : static_cast<S>(c) * a;
  sum = any ? sum + part : part;
  any = true;
}

}  // namespace detail

// What follows is forced into its caller, since only there the constants are known. Nothing is left of a coefficient
// that is 0, and no product of one that is 1 or -1.

/// R c, c a constant.
template <class S>
[[gnu::always_inline]] constexpr Triple<S> along(const Axes<S>& R, const std::array<double, 3>& c) noexcept {
  Triple<S> sum{};
  bool any = false;
  detail::add_part(sum, any, c[0], R.x);
  detail::add_part(sum, any, c[1], R.y);
  detail::add_part(sum, any, c[2], R.z);
  return sum;
}

/// origin + R c, c a constant.
template <class S>
[[gnu::always_inline]] constexpr Triple<S> along(const Triple<S>& origin, const Axes<S>& R,
                                                 const std::array<double, 3>& c) noexcept {
  Triple<S> sum = origin;
  bool any = true;
  detail::add_part(sum, any, c[0], R.x);
  detail::add_part(sum, any, c[1], R.y);
  detail::add_part(sum, any, c[2], R.z);
  return sum;
}

/// A frame's axes turned by an angle of this sine and cosine about a constant unit axis of its own.
/// Source  Rodrigues' formula; about a coordinate axis only the two others move.
template <class S>
[[gnu::always_inline]] constexpr Axes<S> turned(const Axes<S>& R, const std::array<double, 3>& axis, S sine,
                                                S cosine) noexcept {
  const auto about = [&](const Triple<S>& a, const Triple<S>& b, S s) {  // a -> b is the positive sense
    return std::array<Triple<S>, 2>{cosine * a + s * b, cosine * b - s * a};
  };
  if (axis[0] == 0 && axis[1] == 0) {
    const auto [x, y] = about(R.x, R.y, axis[2] > 0 ? sine : -sine);
    return {x, y, R.z};
  }
  if (axis[0] == 0 && axis[2] == 0) {
    const auto [z, x] = about(R.z, R.x, axis[1] > 0 ? sine : -sine);
    return {x, R.y, z};
  }
  if (axis[1] == 0 && axis[2] == 0) {
    const auto [y, z] = about(R.y, R.z, axis[0] > 0 ? sine : -sine);
    return {R.x, y, z};
  }
  const Triple<S> a = along(R, axis);
  const auto column = [&](const Triple<S>& e, double share) {
    return cosine * e + ((S(1) - cosine) * static_cast<S>(share)) * a + sine * cross(a, e);
  };
  return {column(R.x, axis[0]), column(R.y, axis[1]), column(R.z, axis[2])};
}

}  // namespace articam::math
