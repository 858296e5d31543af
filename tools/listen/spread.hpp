#pragma once
/// @file  How times are spread, in a memory that does not grow with their number.

#include <array>
#include <cstddef>
#include <cstdint>

namespace articam::listen {

/// Counts times in classes that are 1 % wide: quantiles are right to 1 % (from 100 ns to 1000 s), extremes are exact.
class Spread {
 public:
  /// Negative ones count as 0.
  void take(double t_s);

  std::uint64_t size() const { return size_; }
  double min() const { return min_s_; }  ///< 0 of none, like all below
  double max() const { return max_s_; }
  /// The value below which a share of them lies.
  double quantile(double share) const;

 private:
  static constexpr std::size_t kClasses = 2320;  ///< ln(1e10) / ln(1.01), and a few

  std::array<std::uint64_t, kClasses> classes_{};
  std::uint64_t size_{};
  double min_s_{}, max_s_{};
};

}  // namespace articam::listen
