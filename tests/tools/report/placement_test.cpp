#include "tools/report/placement.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/tools/report/urdf_text.hpp"

namespace articam::report {
namespace {

const std::string kBase = test::dot("a", "base", "-0.1 -0.1 0") + test::dot("b", "base", "0.1 -0.1 0") +
                          test::dot("c", "base", "0.1 0.1 0") + test::dot("d", "base", "-0.05 0.1 0");
/// Two drawers, one below the other; only the lower one carries a mark.
const std::string kDrawers = kBase + test::slide("upper", "base", "upper_drawer", "1 0 0") +
                             test::slide("lower", "upper_drawer", "lower_drawer", "1 0.5 0") +
                             test::dot("e", "lower_drawer", "0.05 0.2 0");

Conditions conditions() {
  Conditions c;
  c.camera = default_camera();
  c.min_range_m = 0.6;
  c.max_range_m = 0.8;
  c.max_tilt_deg = 40;
  return c;
}

TEST(Advise, SendsTheMarkToTheDrawerThatHasNone) {
  // Two unknown slides and the two coordinates of one mark: a second mark is worth most on either drawer, none on the
  // base.
  const auto table = test::compile(kDrawers, test::dots({"a", "b", "c", "d", "e"})).table;
  const auto views = sample_views(table, conditions());
  const auto advice = advise(table, views, conditions(), 3);
  ASSERT_EQ(advice.size(), 3u);
  EXPECT_EQ(advice[0].candidate.link, "upper_drawer");
  EXPECT_EQ(advice[2].candidate.link, "base");
  EXPECT_GT(advice[0].gain, advice[2].gain);
}

/// The place, written into the URDF as the advice says, gives the deviations that it promises.
TEST(Advise, PromisesWhatTheMarkThenGives) {
  const auto table = test::compile(kDrawers, test::dots({"a", "b", "c", "d", "e"})).table;
  const auto views = sample_views(table, conditions());
  for (const Advice& a : advise(table, views, conditions(), 3)) {
    const Vec3 &p = a.candidate.place, &n = a.candidate.normal;
    const std::string glued =
        test::dot("more", a.candidate.link, fmt::format("{} {} {}", p.x(), p.y(), p.z()),
                  fmt::format("{} {} 0", -std::asin(std::clamp(n.y(), -1.0, 1.0)), std::atan2(n.x(), n.z())));
    const auto with = test::compile(kDrawers + glued, test::dots({"a", "b", "c", "d", "e", "more"})).table;
    for (std::size_t j = 0; j < 2; ++j) {
      std::vector<double> deviations;
      for (std::size_t v = 0; v < views.size(); v += 5) {  // those that the advice looks at
        const Bound b = bound(look(with, views[v], conditions().camera), conditions().noise_px);
        deviations.push_back(b.deviation[static_cast<Eigen::Index>(6 + j)]);
      }
      // The advice knows the limits beforehand, quarters of 0.2 m: nothing beside tenths of a millimetre.
      EXPECT_NEAR(median(deviations) / a.median_with[j], 1, 1e-3) << a.candidate.link;
    }
  }
}

TEST(Candidates, KeepOffTheMarksThatAreThereAndTakeTheUsersPoints) {
  modelgen::ModelOptions options = modelgen::test::with_points({"corner=upper_drawer:0.1,0.3,0"});
  const auto table = modelgen::test::compile_text(modelgen::test::robot("<link name='base'/>" + kDrawers),
                                                  test::dots({"a", "b", "c", "d", "e"}), options)
                         .model->table;
  const auto all = candidates(table);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Candidate& c) { return c.name == "corner"; }), 1);
  for (const Candidate& c : all) {
    for (const auto& marker : table.markers) {
      if (marker.body != c.body || marker.kind == model::MarkerKind::point) continue;
      EXPECT_GE((marker.t_body_m - c.t_body_m).norm(), 1.5 * 0.03) << c.link;
    }
  }
}

}  // namespace
}  // namespace articam::report
