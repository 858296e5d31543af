#include "tools/report/placement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

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

/// The place, written into the URDF as the advice says, has the effect that it promises: also where joints are often
/// not observed.
TEST(Advise, PromisesWhatTheMarkThenGives) {
  for (const std::string name : {"", "door", "cabinet", "arm7"}) {
    SCOPED_TRACE(name);
    const std::string folder = ARTICAM_SOURCE_DIR "/static_models/" + name + "/" + name;
    std::string urdf = modelgen::test::robot("<link name='base'/>" + kDrawers);
    std::string markers = test::dots({"a", "b", "c", "d", "e"});
    if (!name.empty()) urdf = test::read(folder + ".urdf"), markers = test::read(folder + ".markers.yaml");
    const auto table = modelgen::test::compile_text(urdf, markers).model->table;
    Conditions far = conditions();
    far.min_range_m = 0.8, far.max_range_m = 2;
    const auto views = sample_views(table, far);
    const auto best = advise(table, views, far, 1);
    ASSERT_EQ(best.size(), 1u);
    const auto with = modelgen::test::compile_text(test::glue(urdf, best[0].candidate),
                                                   test::glue_marker(markers, best[0].candidate.mark));
    ASSERT_TRUE(with.model) << with.messages;
    for (std::size_t j = 0; j < best[0].effects.size(); ++j) {
      const Effect& effect = best[0].effects[j];
      std::vector<double> deviations;
      double share = 0;
      for (const View& view : views) {
        const Bound before = bound(information(look(table, view, far.camera)), known_beforehand(table), far.noise_px);
        const Bound after =
            bound(information(look(with.model->table, view, far.camera)), known_beforehand(table), far.noise_px);
        share += after.observed[6 + j] ? 1 / static_cast<double>(views.size()) : 0;
        if (!before.observed[6 + j] || !after.observed[6 + j]) continue;
        deviations.push_back(after.deviation[static_cast<Eigen::Index>(6 + j)]);
      }
      EXPECT_NEAR(share, effect.share_with, 0.01) << effect.name;
      if (deviations.empty()) continue;
      EXPECT_NEAR(median(deviations) / effect.median_with, 1, 1e-3) << effect.name;
    }
  }
}

TEST(Advise, LooksFromEveryDirection) {
  // It takes every seventh view; the directions come in 25s.
  const auto table = test::compile(kDrawers, test::dots({"a", "b", "c", "d", "e"})).table;
  const auto views = sample_views(table, conditions());
  std::set<std::pair<double, double>> all, some;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::pair<double, double> from{std::round(1e6 * views[i].from.x()), std::round(1e6 * views[i].from.y())};
    all.insert(from);
    if (i % 7 == 0) some.insert(from);
  }
  EXPECT_EQ(some, all);
}

TEST(Candidates, KeepOffTheMarksThatAreThereAndTakeTheUsersPoints) {
  modelgen::ModelOptions options = modelgen::test::with_points({"corner=upper_drawer:0.1,0.3,0"});
  const auto table = modelgen::test::compile_text(modelgen::test::robot("<link name='base'/>" + kDrawers),
                                                  test::dots({"a", "b", "c", "d", "e"}), options)
                         .model->table;
  const auto all = candidates(table);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Candidate& c) { return c.point == "corner"; }), 1);
  for (const Candidate& c : all) {
    EXPECT_EQ(c.mark.outer_diameter_m, 0.03);
    EXPECT_EQ(c.mark.kind, model::MarkerKind::dot_dark_on_light) << "of the kind that is there";
    for (const auto& marker : table.markers) {
      if (marker.body != c.mark.body || !is_mark(marker)) continue;
      EXPECT_GE((marker.t_body_m - c.mark.t_body_m).norm(), 1.5 * 0.03) << c.link;
    }
  }
}

}  // namespace
}  // namespace articam::report
