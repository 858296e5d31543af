#include "tools/probe/probe.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "static_models/registry.hpp"
#include "tests/tools/modelgen/urdf_oracle.hpp"

namespace articam::probe {
namespace {

using modelgen::test::Matrix4;
using modelgen::test::UrdfOracle;

std::string urdf_of(std::string_view name) {
  const std::string folder(name);
  std::ifstream stream(ARTICAM_SOURCE_DIR "/static_models/" + folder + "/" + folder + ".urdf");
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class Model>
std::string probe(const std::string& lines) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* const out = ::open_memstream(&text, &size);
  std::istringstream in(lines);
  EXPECT_EQ(run<Model>(in, out, stderr), 0);
  std::fclose(out);
  const std::string result(text, size);
  std::free(text);
  return result;
}

/// Every line of a block against the second reading of the URDF and its numeric derivative.
template <class Model>
void expect_block(const UrdfOracle& oracle, std::map<std::string, double> values, std::istringstream& block) {
  std::string word, marker, joint;
  std::array<double, 6> got{};
  const auto read_numbers = [&] {
    for (double& x : got) block >> x;
  };
  for (const auto& row : Model::kMarkers) {
    const Matrix4 pose = oracle.pose(std::string(row.name), values);
    block >> word >> marker;
    read_numbers();
    EXPECT_EQ(word, "marker");
    EXPECT_EQ(marker, row.name);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(got[i], pose[i][3], 1e-14);  // a few roundings of numbers below 1
      EXPECT_NEAR(got[3 + i], pose[i][2], 1e-14);
    }
    for (const auto& joint_row : model::kValueRows<Model>) {
      block >> word >> marker >> joint;
      read_numbers();
      EXPECT_EQ(word, "jac");
      EXPECT_EQ(marker, row.name);
      EXPECT_EQ(joint, joint_row.name);
      constexpr double kStep = 1e-6;  // truncation 1e-12, cancellation 1e-10
      auto ahead = values, behind = values;
      ahead[joint] += kStep;
      behind[joint] -= kStep;
      const Matrix4 a = oracle.pose(marker, ahead), b = oracle.pose(marker, behind);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(got[i], (a[i][3] - b[i][3]) / (2 * kStep), 1e-9);
      // omega x n is the rate of the normal.
      const std::array<double, 3> w{got[3], got[4], got[5]}, n{pose[0][2], pose[1][2], pose[2][2]};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        EXPECT_NEAR(w[j] * n[k] - w[k] * n[j], (a[i][2] - b[i][2]) / (2 * kStep), 1e-9);
      }
    }
  }
  block >> word;
  EXPECT_EQ(word, "end");
}

template <class Model>
void expect_model() {
  const UrdfOracle oracle(urdf_of(Model::kName));
  std::map<std::string, double> values;
  std::string line, head = "joints";
  for (const auto& joint : model::kValueRows<Model>) {
    const bool limited = joint.q_max < model::kUnlimited;
    const double q = limited ? joint.q_min + 0.37 * (joint.q_max - joint.q_min) : 0.37;
    std::ostringstream text;
    text.precision(17);
    text << q << ' ';
    line += text.str();
    values[std::string(joint.name)] = q;
    head += ' ';
    head += joint.name;
  }
  std::istringstream block(probe<Model>(line + "\n"));
  std::string first;
  std::getline(block, first);
  EXPECT_EQ(first, head);
  expect_block<Model>(oracle, values, block);
}

TEST(Word, HasNoBlank) {
  EXPECT_EQ(word("left door"), "left_door");
  EXPECT_EQ(word("hinge"), "hinge");
}

TEST(Probe, AgreesWithASecondReadingOfTheUrdfForEveryStaticModel) {
  for (const auto name : models::kStaticModelNames) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(models::visit_model(name, []<class Model>() { expect_model<Model>(); }));
  }
}

/// A turning joint, so that the angular part is not always zero.
struct Lid {
  static constexpr std::array<model::JointRow, 1> kJoints{
      {{"hinge", model::JointKind::revolute, -1, {0, 0, 1}, {1, 0, 0}, {1, 0, 0, 0}, -2, 2}}};
  static constexpr std::array<model::MarkerRow, 1> kMarkers{
      {{"corner", model::MarkerKind::point, 0, {0.5, 0, 0}, {1, 0, 0}, 0, 0}}};
};

TEST(Probe, GivesTheTwistAtThePointAndNotAtTheOrigin) {
  EXPECT_EQ(probe<Lid>("0\n"),
            "joints hinge\n"
            "marker corner 1.5 0 0 1 0 0\n"
            "jac corner hinge 0 0.5 0 0 0 1\n"
            "end\n");
}

}  // namespace
}  // namespace articam::probe
