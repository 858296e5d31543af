#pragma once
/// @file  The tracker that the table is about, compiled once.

#include "core/tracker/tracker.hpp"
#include "tests/bench/estimator_table/scene.hpp"

extern template class articam::tracker::Tracker<articam::models::PrinterDrawer, double>;

namespace articam::estimator_table {

using PrinterTracker = tracker::Tracker<Printer, double>;
using PrinterEstimate = PrinterTracker::EstimateType;
using PrinterConfiguration = model::Configuration<Printer, double>;

/// The noise of these frames is wholly in the detections' variances; a floor would add what is not there.
inline tracker::Options without_floor() {
  tracker::Options options;
  options.floor_px = 0;
  return options;
}

inline Timestamp time_of(int frame) { return from_seconds(frame * kFrame_s); }

inline bool has_estimate(const PrinterEstimate& estimate) {
  return estimate.status == tracker::TrackingStatus::tracking || estimate.status == tracker::TrackingStatus::degraded;
}

inline double normalised_error(const PrinterEstimate& estimate, const PrinterConfiguration& truth) {
  const Vec8 error = model::difference<Printer, double>(truth, estimate.q);
  return error.dot(estimate.covariance.ldlt().solve(error));
}

}  // namespace articam::estimator_table
