#pragma once
/// @file  A link that keeps every estimate in memory beside the truth, for the report.

#include <functional>
#include <utility>

#include "core/status.hpp"
#include "host_sim/report/record_frame.hpp"
#include "host_sim/report/run_record.hpp"
#include "host_sim/report/svd_baseline.hpp"

namespace articam::sim {

/// The baseline is computed from the very marks that the tracker has just matched, hence the tracker.
template <class Tracker>
class RecordingLink {
 public:
  using Model = typename Tracker::ModelType;
  using Truth = std::function<ObjectState<Model>(double t_s)>;

  RecordingLink(const Tracker& tracker, Truth truth, RunRecord& run)
      : tracker_{tracker}, truth_{std::move(truth)}, run_{run} {}

  Status publish(const typename Tracker::EstimateType& estimate) noexcept {
    FrameRecord record = record_frame(truth_(seconds_between({}, estimate.t_capture)), estimate);
    record.svd = svd_baseline<Model>(tracker_.matches(), tracker_.detections(), tracker_.camera());
    for (const auto& match : tracker_.matches()) {
      if (estimate.matched > 0 && match.matched)
        record.seen.push_back(tracker_.detections()[static_cast<std::size_t>(match.detection)].outer);
    }
    run_.frames.push_back(std::move(record));
    return Status::ok;
  }

 private:
  const Tracker& tracker_;
  Truth truth_;
  RunRecord& run_;
};

}  // namespace articam::sim
