#include "host_sim/report/truth_csv.hpp"

#include <fmt/format.h>

#include <iterator>

namespace articam::sim {

std::string truth_csv(const RunRecord& run) {
  // {} prints the shortest text that reads back as the same number.
  std::string csv = "frame,t_s,px,py,pz,qw,qx,qy,qz";
  for (const std::string& joint : run.joint_names) csv += "," + joint;
  csv += '\n';
  for (const FrameRecord& frame : run.frames) {
    const auto& [R, t] = frame.truth.T_cam_obj;
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{}", frame.frame, frame.t_s, t.x(), t.y(), t.z(),
                   R.w(), R.x(), R.y(), R.z());
    for (const double joint : frame.truth.joints) fmt::format_to(std::back_inserter(csv), ",{}", joint);
    csv += '\n';
  }
  return csv;
}

}  // namespace articam::sim
