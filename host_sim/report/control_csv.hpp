#pragma once
/// @file  What the robot did, as text: every control period, or one line of it all.

#include <span>
#include <string>

#include "host_sim/loop/manipulation.hpp"
#include "host_sim/report/pull_metrics.hpp"
#include "host_sim/report/run_record.hpp"

namespace articam::sim {

/// control.csv: `t_s,target,position,told,hand_vx,hand_vy,hand_vz,pull_n`, one row a control period. SI.
std::string control_csv(std::span<const ControlSample> samples);

/// The contents of feedback.txt: a table with a line for each, in the unit of the joint that is pulled.
std::string feedback_text(const RunRecord& run, std::span<const FeedbackRun> feedbacks);

}  // namespace articam::sim
