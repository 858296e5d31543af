#pragma once
/// @file  What one view tells of every degree of freedom: the Cramer-Rao bound of the marks' centres.

#include <algorithm>
#include <vector>

#include "tools/report/view.hpp"

namespace articam::report {

enum class Sighting { seen, outside_picture, turned_away, too_small };

/// A mark in one view.
struct Sight {
  Sighting sighting{
      Sighting::outside_picture};              ///< the first that applies, in the order too_small, turned_away, outside
  double diameter_px{};                        ///< of its outer circle, seen face to face at its depth
  Eigen::Matrix<double, 2, Eigen::Dynamic> A;  ///< px per (m, rad in {cam}, joint values), order of the step in core
  VectorX across_px;  ///< how far the centre would move by the same steps if it went across the line of sight

  bool seen() const { return sighting == Sighting::seen; }
};

/// Below it the detectors of rings and dots do not answer reliably.
inline constexpr double kMinDiameter_px = 12;
inline constexpr double kMaxTilt_deg = 75;

/// Points without a mark are never seen.
std::vector<Sight> look(const modelgen::Table& table, const View& view, const CameraParameters& camera);

/// Whether entry i of a Bound is a length; an angle otherwise.
bool is_metres(const modelgen::Table& table, std::size_t i);

/// Deviations of what is known before anything is seen, in the order of a Bound: 10 m and half a turn of the base, and
/// of a joint that of any value within its limits, range / sqrt(12).
VectorX known_beforehand(const modelgen::Table& table);

/// Of one view; entries in the order t (3, m), rotation in {cam} (3, rad), joint values (rad or m).
struct Bound {
  std::vector<bool> observed;
  VectorX deviation;  ///< no estimator without bias does better; infinite where not observed
  /// Deviation over that of the same marks moving as far across the line of sight, all else known: 1 is ideal; a drawer
  /// seen along its axis has a large one.
  VectorX dilution;

  bool complete() const { return std::find(observed.begin(), observed.end(), false) == observed.end(); }
};

/// What the marks of one view tell, those that are seen and used.
struct Information {
  MatrixX sum_px2;     ///< sum A'A
  VectorX across_px2;  ///< sum of the squared across_px
};

/// `use[m]`: whether mark m counts.
Information information(const std::vector<Sight>& sights, const std::vector<bool>& use);
/// Of every mark that is seen.
Information information(const std::vector<Sight>& sights);

/// Least singular value of the stacked A in px per step of 1 cm, 1 deg: how far the marks move, all together, in the
/// direction that is worst seen.
double least_singular_px(const Information& information, const modelgen::Table& table);

/// Not observed is what moves no mark by more than rounding, what has a part in an eigenvector of the Jacobi-scaled
/// information whose eigenvalue is below 1e-10, and what is then not better known than beforehand.
Bound bound(const Information& information, const VectorX& beforehand, double noise_px);

}  // namespace articam::report
