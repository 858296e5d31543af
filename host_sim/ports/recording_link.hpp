#pragma once
/// @file  A link that keeps every estimate in memory beside the truth, for the report.

#include "core/status.hpp"
#include "host_sim/report/record_frame.hpp"
#include "host_sim/report/run_record.hpp"
#include "host_sim/report/svd_baseline.hpp"

namespace articam::sim {

/// The baseline is computed from the very marks that the tracker has just matched, hence the tracker.
template <class Scenario, class Tracker>
class RecordingLink {
 public:
  RecordingLink(const Tracker& tracker, RunRecord& run) noexcept : tracker_{tracker}, run_{run} {}

  Status publish(const typename Tracker::EstimateType& estimate) noexcept {
    using Model = typename Scenario::Model;
    FrameRecord record = record_frame(Scenario::at(seconds_between({}, estimate.t_capture)), estimate);
    record.svd = svd_baseline<Model>(tracker_.matches(), tracker_.detections(), tracker_.camera());
    run_.frames.push_back(std::move(record));
    return Status::ok;
  }

 private:
  const Tracker& tracker_;
  RunRecord& run_;
};

}  // namespace articam::sim
