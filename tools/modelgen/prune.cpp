#include "tools/modelgen/prune.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace articam::modelgen {
namespace {

std::size_t index(int row) { return static_cast<std::size_t>(row); }

/// Of every row, whether it moves a marker.
std::vector<bool> find_movers(const Table& table) {
  std::vector<bool> moves(table.joints.size());
  for (const TableMarker& marker : table.markers) {
    for (int row = marker.body; row >= 0; row = table.joints[index(row)].parent) moves[index(row)] = true;
  }
  return moves;
}

void hang_on_root(TableJoint& joint) {
  joint.parent = -1;
  joint.T_parent_joint = {};
}

}  // namespace

void prune(Table& table, const std::string& file, Diagnostics& diagnostics) {
  const auto warn = [&](const TableJoint& joint, const std::string& reason) {
    diagnostics.warning(file, joint.line, title("joint", joint.name), reason);
  };
  if (table.markers.empty()) {
    diagnostics.warning(file, 0, "robot", "no markers and no points: nothing of it can be observed");
    return;
  }
  const std::vector<bool> moves = find_movers(table);
  std::vector<bool> leads(table.joints.size());
  for (std::size_t i = 0; i < table.joints.size(); ++i) {
    if (moves[i] && table.joints[i].leader >= 0) leads[index(table.joints[i].leader)] = true;
  }
  std::vector<int> new_row(table.joints.size(), -1);
  std::vector<TableJoint> kept;
  for (std::size_t i = 0; i < table.joints.size(); ++i) {
    TableJoint& joint = table.joints[i];
    if (!moves[i] && !leads[i]) {
      warn(joint, "moves no marker: left out of the table");
      continue;
    }
    if (!moves[i]) {
      warn(joint, "moves no marker, but a joint that mimics it does: kept for its value");
      hang_on_root(joint);
    }
    new_row[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(joint));
  }
  const auto renumber = [&](int& row) { row = row < 0 ? -1 : new_row[index(row)]; };
  for (TableJoint& joint : kept) {
    renumber(joint.parent);
    renumber(joint.leader);
  }
  for (TableMarker& marker : table.markers) renumber(marker.body);
  table.joints = std::move(kept);
}

}  // namespace articam::modelgen
