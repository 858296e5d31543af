#include "tools/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "static_models/registry.hpp"
#include "tests/tools/report/static_table.hpp"
#include "tests/tools/report/urdf_text.hpp"

namespace articam::report {
namespace {

Conditions conditions() {
  Conditions c;
  c.camera = default_camera();
  return c;
}

Report printer() {
  modelgen::CompiledModel model;
  model.table = test::static_table("printer_drawer");
  return make_report(model, conditions());
}

TEST(Report, SaysWhatEachMarkIsGoodFor) {
  const Report report = printer();
  const auto& losses = report.over_views.losses;
  ASSERT_EQ(losses.size(), 6u);
  const Loss& second = losses[5];  // on the drawer: alone in telling of its distance
  ASSERT_FALSE(second.blinded.empty());
  const auto distance = std::find_if(second.blinded.begin(), second.blinded.end(),
                                     [](const Blinded& b) { return b.name == "marker_distance"; });
  ASSERT_NE(distance, second.blinded.end());
  EXPECT_EQ(distance->num_without, 0u);
  EXPECT_GT(distance->num_with, 0u);
  EXPECT_EQ(second.at_start, std::vector<std::string>{"marker_distance"});
  for (std::size_t m = 0; m < 5; ++m) EXPECT_TRUE(losses[m].at_start.empty()) << losses[m].marker;
}

TEST(Report, NamesTheViewAlongTheDrawer) {
  const Report report = printer();
  const Freedom& drawer = report.over_views.freedoms.at(6);
  EXPECT_EQ(drawer.name, "drawer_slide");
  EXPECT_GT(drawer.share_weak, 0);
  EXPECT_EQ(report.views[drawer.worst_view].tilt_deg, 0);
  EXPECT_NE(to_text(report).find("drawer_slide is worst at range"), std::string::npos);
}

TEST(Report, CallsMarksTooSmallForTheRange) {
  modelgen::CompiledModel model;
  model.table = test::static_table("printer_drawer");
  Conditions far = conditions();
  far.max_range_m = 2.2;  // rings of 5 cm at 525 px are 12 px at 2.19 m
  const Report report = make_report(model, far);
  EXPECT_NEAR(report.sizes[0].max_range_m, 2.1875, 1e-12);
  EXPECT_NE(to_text(report).find("TOO SMALL"), std::string::npos);
  EXPECT_EQ(to_text(printer()).find("TOO SMALL"), std::string::npos);
}

TEST(Report, CountsLinksJointsAndWhatBecameOfThem) {
  const auto model =
      test::compile(test::dot("a", "base", "0 0 0") + test::slide("used", "base", "drawer", "1 0 0") +
                        test::dot("b", "drawer", "0.1 0 0") + test::slide("unused", "base", "flap", "1 0 0"),
                    test::dots({"a", "b"}));
  const Report report = make_report(model, conditions());
  EXPECT_EQ(report.num_links, 5u);
  EXPECT_EQ(report.num_joints, 4u);
  EXPECT_EQ(report.num_fixed, 2u);
  EXPECT_EQ(report.num_left_out, 1u);
}

TEST(Report, SaysHowFarAJointMovesForTheSakeOfOneThatMimicsIt) {
  const auto model =
      test::compile(test::dot("a", "base", "0 0 0") + test::slide("leads", "base", "drawer", "1 0 0") +
                        test::dot("b", "drawer", "0.1 0 0") + "<link name='flap'/>" +
                        test::joint("follows", "revolute", "base", "flap",
                                    "<limit lower='0' upper='0.3'/><mimic joint='leads' multiplier='2'/>") +
                        test::dot("c", "flap", "0 0.1 0"),
                    test::dots({"a", "b", "c"}));
  EXPECT_NE(
      to_text(make_report(model, conditions())).find("  leads moves between 0 and 0.15, where follows can follow\n"),
      std::string::npos);
}

TEST(Report, TakesAJointForNoNumberOfTheBaseWhateverItsName) {
  const auto model =
      test::compile(test::dot("a", "base", "-0.1 -0.1 0") + test::dot("b", "base", "0.1 -0.1 0") +
                        test::dot("c", "base", "0.1 0.1 0") + test::dot("d", "base", "-0.05 0.1 0") +
                        test::slide("tx", "base", "drawer", "1 0.3 0") + test::dot("e", "drawer", "0 0 0.02"),
                    test::dots({"a", "b", "c", "d", "e"}));
  const Report report = make_report(model, conditions());
  const auto& blinded = report.over_views.losses.at(4).blinded;
  ASSERT_FALSE(blinded.empty());
  EXPECT_EQ(blinded.back().name, "tx");
  EXPECT_FALSE(blinded.back().is_of_base);
}

TEST(Report, SaysTheSameInJson) {
  const Report report = printer();
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json["model"], "printer_drawer");
  EXPECT_EQ(json["degrees_of_freedom"].size(), 8u);
  EXPECT_EQ(json["degrees_of_freedom"][6]["name"], "drawer_slide");
  EXPECT_EQ(json["degrees_of_freedom"][6]["median_deviation"], report.over_views.freedoms[6].median);
  EXPECT_EQ(json["marks"][5]["without_it"]["not_observed_at_q0"][0], "marker_distance");
  EXPECT_EQ(json["least_singular_view"]["joints"].size(), 2u);
  EXPECT_EQ(json["one_more_mark"].size(), report.advice.size());
  EXPECT_TRUE(json["look_alikes"].empty());
}

TEST(Report, OfAModelWithoutMarksSaysSo) {
  modelgen::CompiledModel model;
  model.table = test::static_table("printer_drawer");
  model.table.markers.clear();
  const Report report = make_report(model, conditions());
  EXPECT_NE(to_text(report).find("nothing will be observed"), std::string::npos);
  EXPECT_TRUE(nlohmann::json::parse(to_json(report))["marks"].empty());
}

/// The three poses of the published table that tell a weak drawer from one that is not, as a person would ask for them.
TEST(Report, CallsTheDrawerWeakAtQ0OnlyWhereItIsSeenFaceToFace) {
  const auto at_q0 = [](const std::vector<double>& q0) {
    modelgen::CompiledModel model;
    model.table = test::static_table("printer_drawer");
    model.table.q0 = q0;
    const std::string text = to_text(make_report(model, conditions()));
    const auto row = text.find("\n  drawer_slide");
    return text.substr(row, text.find('\n', row + 1) - row);
  };
  const double w = 0.96162, x = 0.26108, y = -0.07294, z = 0.06396;  // Rz(5 deg) Ry(-10 deg) Rx(30 deg), to 5 digits
  EXPECT_EQ(at_q0({0.02, 0.08, 0.70, w, x, y, z, 0.08, 0.12}).find(" mm WEAK "), std::string::npos);
  EXPECT_EQ(at_q0({0.02, 0.08, 0.70, w, x, y, z, 0, 0.12}).find(" mm WEAK "), std::string::npos);
  EXPECT_NE(at_q0({0.02, 0.08, 0.70, 1, 0, 0, 0, 0.08, 0.12}).find(" mm WEAK "), std::string::npos);
}

TEST(Report, OfEveryStaticModelHasNoAngleBeyondHalfATurnAndNoNumberThatIsNone) {
  for (const auto name : models::kStaticModelNames) {
    SCOPED_TRACE(name);
    modelgen::CompiledModel model;
    model.table = test::static_table(std::string(name));
    const Report report = make_report(model, conditions());
    const std::string text = to_text(report);
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.find("inf "), std::string::npos) << text;
    for (const Freedom& f : report.over_views.freedoms) {
      if (f.share_observed == 0) continue;
      EXPECT_LT(f.worst, f.is_metres ? 10 : std::numbers::pi) << f.name;
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 160u) << line;
  }
}

}  // namespace
}  // namespace articam::report
