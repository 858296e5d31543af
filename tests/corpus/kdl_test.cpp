#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "tests/corpus/corpus.hpp"
#include "tests/corpus/kdl_oracle.hpp"

namespace articam::test {
namespace {

constexpr std::uint64_t kSeed = 20260101;

std::string read(const char* name) {
  const std::filesystem::path others = std::filesystem::path(ARTICAM_URDF_CORPUS) / name;
  std::ifstream stream(std::filesystem::exists(others) ? others : std::filesystem::path(ARTICAM_OWN_URDF) / name);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What urdfdom is too strict for; the corpus's manifest says so of these.
const std::set<std::string> kRelaxed{
    "Daniella1__urdf_files_dataset__open_manipulator.urdf", "RobotLocomotion__drake__Acrobot_unicode.urdf",
    "RobotLocomotion__drake__cassie_v2.urdf", "RobotLocomotion__models__pr2_simplified.urdf",
    "zt-yang__pybullet-planning__hand_se3.urdf"};

TEST(KdlCorpus, EveryFileThatTheOracleAcceptsIsAccepted) {
  int accepted = 0;
  for (const CorpusFile& file : corpus()) {
    const bool oracle = KdlOracle(read(file.name), kRelaxed.count(file.name) > 0).accepts();
    EXPECT_EQ(file.evaluate != nullptr, oracle) << file.name << ": " << file.refusal;
    if (file.evaluate != nullptr) ++accepted;
  }
  EXPECT_EQ(accepted, 56);  // one of them our own
}

std::map<std::string, double> values_of(const KdlOracle& oracle, const Evaluated& ours, const Evaluation& one) {
  std::map<std::string, double> values;
  for (std::size_t j = 0; j < ours.joints.size(); ++j) {
    EXPECT_TRUE(oracle.has_joint(ours.joints[j])) << ours.joints[j];
    values[ours.joints[j]] = one.joints[j];
  }
  return values;
}

/// Of all points of a file, as parts of their reach.
struct Worst {
  double place{}, place_float{}, twist{};
};

Worst compare(KdlOracle& oracle, const Evaluated& ours, const Evaluation& one) {
  Worst worst;
  oracle.set(values_of(oracle, ours, one));
  for (std::size_t m = 0; m < ours.points.size(); ++m) {
    const std::string& link = ours.points[m];
    const double reach = std::max(oracle.reach(link), 1e-3);  // a leaf on the root itself
    const auto place = oracle.place(link);
    for (std::size_t i = 0; i < 3; ++i) {
      worst.place = std::max(worst.place, std::abs(one.centres[m][i] - place[i]) / reach);
      worst.place_float = std::max(worst.place_float, std::abs(double{one.centres_float[m][i]} - place[i]) / reach);
    }
    const auto twists = oracle.twists(link);
    for (std::size_t j = 0; j < ours.joints.size(); ++j) {
      const auto& twist = twists.at(ours.joints[j]);
      const auto& column = one.twists[m * ours.joints.size() + j];
      for (std::size_t i = 0; i < 6; ++i) worst.twist = std::max(worst.twist, std::abs(column[i] - twist[i]));
    }
  }
  return worst;
}

TEST(KdlCorpus, PlacesAndTwistsAreThoseOfKdl) {
  Worst worst_of_all;
  int compared = 0;
  for (const CorpusFile& file : corpus()) {
    if (file.evaluate == nullptr) continue;
    ++compared;
    SCOPED_TRACE(testing::Message() << file.name << ", seed " << kSeed);
    KdlOracle oracle(read(file.name), kRelaxed.count(file.name) > 0);
    ASSERT_TRUE(oracle.accepts());
    const Evaluated ours = file.evaluate(kSeed);
    Worst worst;
    for (const Evaluation& one : ours.configurations) {
      const Worst here = compare(oracle, ours, one);
      worst = {std::max(worst.place, here.place), std::max(worst.place_float, here.place_float),
               std::max(worst.twist, here.twist)};
    }
    EXPECT_LT(worst.place, 1e-12);  // rows are rounded to 15 decimals, chains have some 20 of them
    EXPECT_LT(worst.place_float, 1e-5);
    EXPECT_LT(worst.twist, 1e-10);
    worst_of_all = {std::max(worst.place, worst_of_all.place), std::max(worst.place_float, worst_of_all.place_float),
                    std::max(worst.twist, worst_of_all.twist)};
  }
  std::printf("%d files, worst of all: place %.1e, in float %.1e, twist %.1e\n", compared, worst_of_all.place,
              worst_of_all.place_float, worst_of_all.twist);
}

}  // namespace
}  // namespace articam::test
