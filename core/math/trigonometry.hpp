#pragma once
/// @file  sin, cos, atan2 and exp from + - x / alone, so that every machine computes the same bits.
///
/// libm differs between machines in the last bit, and that bit grows into another estimate. These are
/// plain IEEE arithmetic in the type S, float or double, without a wider type; they hold at compile time
/// too. Largest errors found against 113-bit arithmetic: sin and cos 0.82 ulp, atan2 0.66, exp 0.92.
///
/// Source  Method: Muller, "Elementary Functions", 3rd ed., 2016: chapter 3 (Remez), section 11.2 (Cody and
///         Waite). The polynomials are our own Remez fits, made with 60 digits and then rounded to S; each
///         is fitted to the relative error of the whole function, which stays below the stated power of 2.

#include <bit>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace articam::math {

static_assert(FLT_EVAL_METHOD == 0, "float and double must be computed in their own precision");

template <class S>
struct SinCos {
  S sin{}, cos{};
};

/// The largest |angle| that sin_cos takes: the multiples of pi/2 are exact up to here.
template <class S>
inline constexpr S kMaxAngle_rad = sizeof(S) == 4 ? S(1e4) : S(1e6);

namespace detail {

// clang-format off
template <class S> struct Trigonometry;

template <> struct Trigonometry<double> {
  using Bits = std::uint64_t;
  // pi/2 in pieces short enough that any whole multiple in the domain is exact; likewise pi/4 (x 0 to 4) and ln 2.
  static constexpr double kHalfPi[]{0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
  static constexpr double kQuarterPi[]{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
  static constexpr double kLn2[]{0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};
  static constexpr double kSplitter = 0x1p27 + 1;                              // halves a 53-bit significand
  static constexpr double kSin[]{  // (sin r - r) / r^3 in r^2, |r| <= pi/4: 2^-57
    -0x1.5555555555548p-3,  0x1.111111110f7cap-7,  -0x1.a01a019bfd18p-13,
     0x1.71de3567124f9p-19, -0x1.ae5e59f58b4aep-26, 0x1.5d8fa31c23eabp-33};
  static constexpr double kCos[]{  // (cos r - 1 + r^2/2) / r^4 in r^2, |r| <= pi/4: 2^-63
     0x1.555555555554bp-5,  -0x1.6c16c16c14f8ap-10,  0x1.a01a019c8390fp-16,
    -0x1.27e4f7ea37965p-22,  0x1.1ee9d75291b5dp-29, -0x1.8fa465ee9bbeap-37};
  static constexpr double kAtan[]{  // (atan z - z) / z^3 in z^2, |z| <= tan(pi/8): 2^-59
    -0x1.555555555553dp-2, 0x1.99999999957afp-3, -0x1.24924922a982bp-3, 0x1.c71c70e4bb4dap-4,
    -0x1.745cf8b9c93ecp-4, 0x1.3b1116e3a3d04p-4, -0x1.10eba0ada4f1dp-4, 0x1.df0e0741382bap-5,
    -0x1.9ccd51bbfc035p-5, 0x1.37c87ae879d4ep-5, -0x1.254ea58a910c2p-6};
  static constexpr double kExp[]{  // (exp r - 1 - r) / r^2 in r, |r| <= ln(2)/2: 2^-57
    0x1.000000000000ap-1,  0x1.55555555554fap-3,  0x1.555555555087cp-5,  0x1.1111111127be7p-7,  0x1.6c16c1842a146p-10,
    0x1.a01a012a56eadp-13, 0x1.a0199a0c60599p-16, 0x1.71df2554153f1p-19, 0x1.28ad72d2a4812p-22, 0x1.ad7f6bf5b35fdp-26};
};

template <> struct Trigonometry<float> {
  using Bits = std::uint32_t;
  static constexpr float kHalfPi[]{0x1.92p+0f, 0x1.fb4p-12f, 0x1.444p-24f, 0x1.68cp-39f, 0x1.1a6264p-54f};
  static constexpr float kQuarterPi[]{0x1.921fb0p-1f, 0x1.5110b4p-23f};
  static constexpr float kLn2[]{0x1.62e4p-1f, 0x1.7f7d1cp-20f};
  static constexpr float kSplitter = 0x1p12f + 1;                              // halves a 24-bit significand
  static constexpr float kSin[]{-0x1.555546p-3f, 0x1.11073ap-7f, -0x1.994388p-13f};                  // 2^-28
  static constexpr float kCos[]{0x1.55554ap-5f, -0x1.6c0c32p-10f, 0x1.99eb4ap-16f};                  // 2^-33
  static constexpr float kAtan[]{                                                                     // 2^-30
    -0x1.55554ap-2f, 0x1.999194p-3f, -0x1.23b506p-3f, 0x1.b1ea5ep-4f, -0x1.f1e3e0p-5f};
  static constexpr float kExp[]{                                                                      // 2^-28
    0x1.fffffcp-2f, 0x1.555492p-3f, 0x1.5558f2p-5f, 0x1.1239e2p-7f, 0x1.6a2434p-10f};
};
// clang-format on

/// c[0] + c[1] x + c[2] x^2 + ...
template <class S, std::size_t N>
constexpr S polynomial(const S (&c)[N], S x) noexcept {
  S sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

template <class S>
constexpr int nearest_integer(S x) noexcept {
  return static_cast<int>(x + (x < 0 ? S(-0.5) : S(0.5)));
}

template <class S>
constexpr bool is_negative(S x) noexcept {  // also tells -0 from 0
  using Bits = typename Trigonometry<S>::Bits;
  return (std::bit_cast<Bits>(x) >> (8 * sizeof(S) - 1)) != 0;
}

/// 2^k, for k in the range of normal numbers.
template <class S>
constexpr S power_of_two(int k) noexcept {
  using Limits = std::numeric_limits<S>;
  using Bits = typename Trigonometry<S>::Bits;
  return std::bit_cast<S>(static_cast<Bits>(k + Limits::max_exponent - 1) << (Limits::digits - 1));
}

/// A number kept as the unevaluated sum of two.
template <class S>
struct Pair {
  S hi{}, lo{};
};

/// a + b without any loss (Knuth).
template <class S>
constexpr Pair<S> exact_sum(S a, S b) noexcept {
  const S sum = a + b;
  const S b_kept = sum - a;
  return {sum, (a - (sum - b_kept)) + (b - b_kept)};
}

/// a b without any loss (Dekker), while nothing overflows or underflows.
template <class S>
constexpr Pair<S> exact_product(S a, S b) noexcept {
  const S a_big = Trigonometry<S>::kSplitter * a, b_big = Trigonometry<S>::kSplitter * b;
  const S a_hi = a_big - (a_big - a), b_hi = b_big - (b_big - b);
  const S a_lo = a - a_hi, b_lo = b - b_hi;
  const S product = a * b;
  return {product, a_lo * b_lo - (((product - a_hi * b_hi) - a_lo * b_hi) - a_hi * b_lo)};
}

/// (a - b) / (a + b) where `fold`, else a / b, to twice the precision; 0 < b, and the quotient is not tiny.
template <class S>
constexpr Pair<S> precise_quotient(S a, S b, bool fold) noexcept {
  const Pair<S> numerator = fold ? exact_sum(a, -b) : Pair<S>{a, S(0)};
  const Pair<S> denominator = fold ? exact_sum(a, b) : Pair<S>{b, S(0)};
  const S quotient = numerator.hi / denominator.hi;
  const Pair<S> back = exact_product(quotient, denominator.hi);
  const S rest = ((numerator.hi - back.hi) - back.lo) + (numerator.lo - quotient * denominator.lo);
  return {quotient, rest / denominator.hi};
}

}  // namespace detail

/// Sine and cosine of the same angle.   sin(-x) = -sin(x) and cos(-x) = cos(x), bit by bit; sin(-0) = -0.
/// Errors  both are NaN when the angle is not a number or beyond kMaxAngle_rad.
template <class S>
constexpr SinCos<S> sin_cos(S angle_rad) noexcept {
  using T = detail::Trigonometry<S>;
  constexpr S kNaN = std::numeric_limits<S>::quiet_NaN();
  if (!(angle_rad >= -kMaxAngle_rad<S> && angle_rad <= kMaxAngle_rad<S>)) return {kNaN, kNaN};
  if (angle_rad == S(0)) return {angle_rad, S(1)};

  // angle = k pi/2 + (r.hi + r.lo), |r| <= pi/4. Near a multiple of pi/2 all leading digits cancel, so the
  // rounding of each step is kept in r.lo.
  const int k = detail::nearest_integer(angle_rad * S(0x1.45f306dc9c883p-1));  // 2/pi
  detail::Pair<S> r{angle_rad, S(0)};
  if (k != 0) {
    for (const S piece : T::kHalfPi) {
      const auto difference = detail::exact_sum(r.hi, -static_cast<S>(k) * piece);
      r = {difference.hi, r.lo + difference.lo};
    }
    r = detail::exact_sum(r.hi, r.lo);
  }

  const S r2 = r.hi * r.hi;
  const S half_r2 = S(0.5) * r2;
  const S sine = r.hi + (r.lo * (S(1) - half_r2) + r.hi * (r2 * detail::polynomial(T::kSin, r2)));
  const S leading = S(1) - half_r2;  // 1 - leading is exact, so nothing of r^2/2 is lost
  const S cosine =
      leading + (((S(1) - leading) - half_r2) + (r2 * (r2 * detail::polynomial(T::kCos, r2)) - r.hi * r.lo));

  switch (static_cast<unsigned>(k) & 3u) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

/// The angle (rad, -pi to pi) of the point (x, y) seen from the origin, as C's atan2 has it: odd in y, zeros
/// carry their sign (atan2(+-0, -0) = +-pi), infinities count as equally far.
/// Errors  NaN when x or y is not a number.
template <class S>
constexpr S atan2(S y, S x) noexcept {
  using T = detail::Trigonometry<S>;
  using Limits = std::numeric_limits<S>;
  if (y != y || x != x) return Limits::quiet_NaN();
  const bool y_negative = detail::is_negative(y), x_negative = detail::is_negative(x);
  S a = y_negative ? -y : y;
  S b = x_negative ? -x : x;
  if (a == Limits::infinity() || b == Limits::infinity()) {
    a = a == Limits::infinity() ? S(1) : S(0);
    b = b == Limits::infinity() ? S(1) : S(0);
  }
  if (a == S(0) && b == S(0)) b = S(1);
  const bool swapped = a > b;
  if (swapped) {
    const S larger = a;
    a = b;
    b = larger;
  }

  // Keep the products below clear of overflow and underflow; only the ratio counts.
  constexpr S kLarge = detail::power_of_two<S>(Limits::max_exponent / 2);
  if (b > kLarge) a *= S(1) / kLarge, b *= S(1) / kLarge;
  if (b < S(1) / kLarge) a *= kLarge, b *= kLarge;

  // The angle is m pi/4 +- atan(z), |z| <= tan(pi/8); a tiny quotient is its own arc tangent.
  const bool fold = a > S(0x1.a827999fcef32p-2) * b;
  const bool tiny = a < Limits::epsilon() * b;
  const auto z = tiny ? detail::Pair<S>{a / b, S(0)} : detail::precise_quotient(a, b, fold);
  const S z2 = z.hi * z.hi;
  S m = fold ? S(1) : S(0);
  S turn = S(1);
  if (swapped) m = S(2) - m, turn = -turn;
  if (x_negative) m = S(4) - m, turn = -turn;
  const auto sum = detail::exact_sum(m * T::kQuarterPi[0], turn * z.hi);
  const S tail = z.hi * (z2 * detail::polynomial(T::kAtan, z2)) + z.lo / (S(1) + z2);
  const S angle = sum.hi + (sum.lo + (m * T::kQuarterPi[1] + turn * tail));
  return y_negative ? -angle : angle;
}

/// e^x.   Infinity above the largest number, gradual underflow to 0 below the smallest.
/// Errors  NaN when x is not a number.
template <class S>
constexpr S exp(S x) noexcept {
  using T = detail::Trigonometry<S>;
  using Limits = std::numeric_limits<S>;
  constexpr S kLn2 = S(0x1.62e42fefa39efp-1);
  if (x != x) return x;
  if (x > S(Limits::max_exponent) * kLn2) return Limits::infinity();
  if (x < S(Limits::min_exponent - Limits::digits - 1) * kLn2) return S(0);

  // e^x = 2^k e^(hi - lo); k times the first piece of ln 2 is exact.
  const int k = detail::nearest_integer(x * S(0x1.71547652b82fep+0));  // 1/ln 2
  const S hi = x - static_cast<S>(k) * T::kLn2[0];
  const S lo = static_cast<S>(k) * T::kLn2[1];
  const S r = hi - lo;
  const S r_lost = (hi - r) - lo;
  const S power = S(1) + (r + (r * r * detail::polynomial(T::kExp, r) + r_lost));
  // In two factors, as 2^k itself may lie outside the normal numbers.
  return power * detail::power_of_two<S>(k / 2) * detail::power_of_two<S>(k - k / 2);
}

}  // namespace articam::math
