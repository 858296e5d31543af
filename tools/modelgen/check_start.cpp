#include "tools/modelgen/check_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tools/modelgen/read_urdf.hpp"

namespace articam::modelgen {

void check_start(const MarkersFile& markers, Diagnostics& diagnostics) {
  if (!markers.q0) return;
  const auto& q0 = *markers.q0;
  const auto refuse = [&](const std::string& reason) {
    diagnostics.error(markers.file, markers.q0_line, "q0", reason);
  };
  if (q0.size() < 7)
    return refuse(fmt::format("has {} numbers; it needs px py pz qw qx qy qz, then the joints", q0.size()));
  const auto far = [](double x) { return std::abs(x) > kMaxCoordinate; };
  if (std::any_of(q0.begin(), q0.end(), far)) return refuse(fmt::format("a number is beyond {:g}", kMaxCoordinate));
  if (!(q0[2] > 0)) refuse("pz is not positive: the base is not in front of the camera");
  const double norm = std::sqrt(q0[3] * q0[3] + q0[4] * q0[4] + q0[5] * q0[5] + q0[6] * q0[6]);
  if (!(std::abs(norm - 1) < 0.01)) {  // a start is typed with two or three digits
    refuse(fmt::format("its quaternion has norm {:.4g}, not 1", norm));
  }
}

void check_start(const Table& table, const MarkersFile& markers, Diagnostics& diagnostics) {
  const auto& q0 = table.q0;
  const auto joints = table.values();
  if (q0.size() != 7 + joints.size()) {
    std::string order = "px py pz qw qx qy qz";
    for (const TableJoint* joint : joints) order += ' ' + joint->name;
    diagnostics.error(markers.file, markers.q0_line, "q0",
                      fmt::format("has {} numbers instead of {}: {}", q0.size(), 7 + joints.size(), order));
    return;
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const TableJoint& joint = *joints[i];
    if (q0[7 + i] >= joint.q_min && q0[7 + i] <= joint.q_max) continue;
    diagnostics.warning(markers.file, markers.q0_line, "q0", fmt::format("{} is outside its limits", joint.name));
  }
}

}  // namespace articam::modelgen
