#pragma once
/// @file  Frames that do not come as they should, one fault each, and what must then be said.

#include "host_sim/scenarios/faulty_paper.hpp"

namespace articam::sim {

inline std::vector<FaultyPaper> camera_faults() {
  using enum FaultKind;
  using enum tracker::TrackingStatus;
  using enum tracker::Reason;
  constexpr double kFrom_s = kFaultFrom_s, kTo_s = kFaultTo_s, kEnd_s = kFaultyEnd_s;
  return {
      faulty_paper("dropped_frames", "half of the frames are lost", {{dropped, kFrom_s, kTo_s, 0.5}},
                   {{kFrom_s, kEnd_s, tracking, none},
                    {kFrom_s, kTo_s, coasting, no_frame},          // two in a row
                    {kFrom_s, kTo_s, degraded, camera_stalled}}),  // three
      faulty_paper("late_frames", "every frame arrives 120 ms late", {{late, kFrom_s, kTo_s, 0.12}},
                   {{kFrom_s, kFrom_s + 0.2, coasting, no_frame},
                    {kFrom_s, kFrom_s + 0.2, degraded, camera_stalled},
                    {kFrom_s, kTo_s + 0.1, tracking, late_result},
                    {kTo_s, kEnd_s, tracking, none}}),
      faulty_paper("repeated_frames", "every frame comes twice", {{repeated, kFrom_s, kTo_s, 1}},
                   {{kFrom_s, kEnd_s, tracking, none}, {kFrom_s, kTo_s, coasting, stale_frame}}),
      faulty_paper("silent_camera", "the camera gives nothing", {{silent, kFrom_s, kTo_s, 1}},
                   {{kFrom_s, kFrom_s + 0.15, coasting, no_frame},
                    {kFrom_s, kFrom_s + 0.4, degraded, camera_stalled},
                    {kFrom_s + 0.3, kTo_s + 0.1, lost, camera_stalled},
                    {kTo_s, kEnd_s, tracking, none}}),
      faulty_paper("unplugged_camera", "the camera is unplugged, and plugged in again",
                   {{unplugged, kFrom_s, kTo_s, 1}},
                   {{kFrom_s, kTo_s, lost, camera_gone},
                    {kTo_s, kTo_s + 0.1, lost, camera_stalled},
                    {kTo_s, kEnd_s, tracking, none}}),
      // A stamp of the future cannot be true, and one before the last frame's is none later: both are refused.
      faulty_paper("stamps_ahead", "the camera's clock leaps ahead by 2 s, and back", {{stamped, kFrom_s, kTo_s, 2}},
                   {{kFrom_s, kTo_s, coasting, stale_frame},
                    {kFrom_s, kTo_s, degraded, camera_stalled},
                    {kFrom_s, kTo_s + 0.1, lost, camera_stalled},
                    {kTo_s, kEnd_s, tracking, none}}),
      faulty_paper("stamps_behind", "the camera's clock leaps back by 0.6 s, and ahead again",
                   {{stamped, kFrom_s, kTo_s, -0.6}},
                   {{kFrom_s, kFrom_s + 0.7, coasting, stale_frame},
                    {kFrom_s, kFrom_s + 0.7, degraded, camera_stalled},
                    {kFrom_s, kFrom_s + 0.7, lost, camera_stalled},
                    {kFrom_s, kTo_s, tracking, late_result},
                    {kTo_s, kEnd_s, tracking, none}}),
      faulty_paper("cut_buffers", "buffers lack half of their rows, or a byte of each", {{cut, kFrom_s, kTo_s, 1}},
                   {{kFrom_s, kFrom_s + 0.6, coasting, image_mismatch},
                    {kFrom_s + 0.4, kTo_s, fault, image_mismatch},
                    {kTo_s, kEnd_s, tracking, none}}),
  };
}

}  // namespace articam::sim
