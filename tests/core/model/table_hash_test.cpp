#include "core/model/table_hash.hpp"

#include <gtest/gtest.h>

#include <set>

#include "static_models/registry.hpp"
#include "tests/support/test_arm.hpp"

namespace articam {
namespace {

using model::table_hash;
using test::Arm;

/// FNV's own test vectors are of plain bytes; put() of a text puts its length first, so they are met by numbers:
/// eight zero bytes.
static_assert([] {
  model::Fnv1a hash;
  hash.put(std::uint64_t{0});
  return hash.value();
}() == 0xa8c7f832281a39c5U);

template <auto Change>
struct Changed : Arm {
  static constexpr auto kJoints = [] {
    auto rows = Arm::kJoints;
    Change(rows[1]);
    return rows;
  }();
};
template <auto Change>
struct ChangedMarker : Arm {
  static constexpr auto kMarkers = [] {
    auto rows = Arm::kMarkers;
    Change(rows[1]);
    return rows;
  }();
};
struct OtherStart : Arm {
  static constexpr bool kHasQ0 = !Arm::kHasQ0;
};

TEST(TableHash, ChangesWithEveryFieldOfEveryRow) {
  using model::JointRow, model::MarkerRow;
  const std::set<std::uint64_t> hashes{
      table_hash<Arm>(),
      table_hash<Changed<[](JointRow& r) { r.name = "other"; }>>(),
      table_hash<Changed<[](JointRow& r) { r.kind = model::JointKind::continuous; }>>(),
      table_hash<Changed<[](JointRow& r) { r.parent = -1 - r.parent; }>>(),
      table_hash<Changed<[](JointRow& r) { r.axis[2] += 0.5; }>>(),
      table_hash<Changed<[](JointRow& r) { r.t_parent_joint_m[0] += 1e-12; }>>(),
      table_hash<Changed<[](JointRow& r) { r.r_parent_joint_wxyz[3] += 0.5; }>>(),
      table_hash<Changed<[](JointRow& r) { r.q_min -= 1; }>>(),
      table_hash<Changed<[](JointRow& r) { r.q_max += 1; }>>(),
      table_hash<Changed<[](JointRow& r) { r.leader = 0; }>>(),
      table_hash<Changed<[](JointRow& r) { r.ratio = 2; }>>(),
      table_hash<Changed<[](JointRow& r) { r.offset = 0.1; }>>(),
      table_hash<ChangedMarker<[](MarkerRow& r) { r.name = "other"; }>>(),
      table_hash<ChangedMarker<[](MarkerRow& r) { r.kind = model::MarkerKind::dot_dark_on_light; }>>(),
      table_hash<ChangedMarker<[](MarkerRow& r) { r.body = -1 - r.body; }>>(),
      table_hash<ChangedMarker<[](MarkerRow& r) { r.t_body_m[1] += 1e-12; }>>(),
      table_hash<ChangedMarker<[](MarkerRow& r) { r.normal[0] += 0.5; }>>(),
      table_hash<ChangedMarker<[](MarkerRow& r) { r.outer_diameter_m += 0.01; }>>(),
      table_hash<ChangedMarker<[](MarkerRow& r) { r.inner_diameter_m += 0.01; }>>()};
  EXPECT_EQ(hashes.size(), 19u);
}

TEST(TableHash, IsIndifferentToWhereATrackerBegins) { EXPECT_EQ(table_hash<OtherStart>(), table_hash<Arm>()); }

TEST(TableHash, TellsOurModelsApart) {
  std::set<std::uint64_t> hashes;
  for (const auto name : models::kStaticModelNames) {
    models::visit_model(name, [&]<class Model>() { hashes.insert(table_hash<Model>()); });
  }
  EXPECT_EQ(hashes.size(), models::kStaticModelNames.size());
}

}  // namespace
}  // namespace articam
