#include <nlohmann/json.hpp>

#include "host_sim/report/metrics.hpp"

namespace articam::sim {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const std::optional<Interval>& interval) {
  if (!interval) return nullptr;
  return {{"value", interval->value}, {"low_95", interval->low}, {"high_95", interval->high}};
}

Json to_json(const JointMetrics& joint, const std::string& rival) {
  Json json{{"unit", joint.is_length ? "mm" : "mrad"}, {"rms", joint.rms}, {"mean", joint.mean}, {"max", joint.max}};
  json["within_3_sigma"] = joint.within_3_sigma;
  if (joint.is_length) json["svd_rms"] = joint.svd_rms;
  if (!rival.empty()) json[rival + "_rms"] = joint.rival_rms;
  json["lag_ms"] = to_json(joint.lag_ms);
  return json;
}

}  // namespace

std::string metrics_json(const RunRecord& run, const Metrics& metrics) {
  Json json{{"scenario", run.scenario},
            {"mode", run.mode},
            {"seed", run.seed},
            {"noise_grey", run.noise_grey},
            {"blur_px", run.blur_px},
            {"frames", run.frames.size()},
            {"frames_by_status", Json::object()},
            {"evaluated_from_s", kEvaluatedFrom_s},
            {"evaluated_frames", metrics.evaluated},
            {"joints", Json::object()}};
  for (std::size_t i = 0; i < metrics.frames_by_status.size(); ++i) {
    json["frames_by_status"][std::string{name(static_cast<tracker::TrackingStatus>(i))}] = metrics.frames_by_status[i];
  }
  for (const JointMetrics& joint : metrics.joints) json["joints"][joint.name] = to_json(joint, run.rival_mode);
  json["base"] = {{"position_rms_mm", metrics.position_rms_mm},
                  {"orientation_rms_deg", metrics.orientation_rms_deg},
                  {"svd_position_rms_mm", metrics.svd_position_rms_mm},
                  {"svd_orientation_rms_deg", metrics.svd_orientation_rms_deg}};
  if (!run.rival_mode.empty()) {
    json["base"][run.rival_mode + "_position_rms_mm"] = metrics.rival_position_rms_mm;
    json["base"][run.rival_mode + "_orientation_rms_deg"] = metrics.rival_orientation_rms_deg;
  }
  json["decay_rate_per_s"] = to_json(metrics.decay_rate_per_s);
  json["median_rms_px"] = metrics.median_rms_px;
  json["nees"] = {{"mean", metrics.mean_nees}, {"degrees_of_freedom", run.degrees_of_freedom}};
  json["step_time_ms"] = {
      {"median", metrics.step_median_ms}, {"p99", metrics.step_p99_ms}, {"max", metrics.step_max_ms}};
  return json.dump(2) + "\n";
}

}  // namespace articam::sim
