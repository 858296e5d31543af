#include "tests/architecture/floors.hpp"

#include <gtest/gtest.h>

namespace articam::architecture {
namespace {

std::string findings(std::string_view path, std::string_view text) { return to_string(check_includes(path, text)); }

TEST(Floors, HoldInTheWholeRepository) {
  Violations all;
  for (const SourceFile& file : read_source_tree()) {
    for (Violation& violation : check_includes(file.path, file.text)) all.push_back(std::move(violation));
  }
  EXPECT_TRUE(all.empty()) << "\n" << to_string(all);
}

TEST(Floors, EveryViolationIsNamedWithItsFileAndLine) {
  EXPECT_EQ(
      findings("core/math/so3.hpp", "#pragma once\n#include \"core/model/model_table.hpp\"\n\n#include <vector>\n"),
      "core/math/so3.hpp:2: core/math/ may not include \"core/model/model_table.hpp\"\n"
      "core/math/so3.hpp:4: <vector> is not in the heap-free part of std\n");
}

TEST(Floors, ModelAndVisionNeverIncludeEachOther) {
  EXPECT_NE(findings("core/model/a.hpp", "#include \"core/vision/detection.hpp\""), "");
  EXPECT_NE(findings("core/vision/a.cpp", "#include \"core/model/model_table.hpp\""), "");
  EXPECT_EQ(findings("core/tracker/a.hpp", "#include \"core/vision/detection.hpp\"\n#include \"core/model/a.hpp\""),
            "");
}

TEST(Floors, NothingIncludesAFloorAbove) {
  EXPECT_NE(findings("core/math/a.hpp", "#include \"core/tracker/estimate.hpp\""), "");
  EXPECT_NE(findings("core/status.hpp", "#include \"core/model/model_table.hpp\""), "");
  EXPECT_NE(findings("core/tracker/a.hpp", "#include \"hal/ports/camera_port.hpp\""), "");
  EXPECT_NE(findings("static_models/mire/mire.hpp", "#include \"core/tracker/estimate.hpp\""), "");
  EXPECT_NE(findings("hal/ports/a.hpp", "#include \"hal/replay/a.hpp\""), "");
  EXPECT_NE(findings("hal/run_loop.hpp", "#include \"static_models/mire/mire.hpp\""), "");
  EXPECT_NE(findings("tools/modelgen/a.cpp", "#include \"core/tracker/estimate.hpp\""), "");
}

TEST(Floors, ImplementationsOfThePortsNeverIncludeEachOther) {
  EXPECT_EQ(findings("hal/replay/a.cpp", "#include \"hal/replay/a.hpp\"\n#include <filesystem>"), "");
  EXPECT_NE(findings("hal/replay/a.cpp", "#include \"hal/link/a.hpp\""), "");
  EXPECT_EQ(findings("hal/replay/a.cpp", "#include \"hal/posix/a.hpp\""), "") << "all may stand on that";
  EXPECT_NE(findings("hal/posix/a.cpp", "#include \"hal/replay/a.hpp\""), "");
  EXPECT_NE(findings("hal/replay/a.cpp", "#include \"host_sim/world/a.hpp\""), "");
  EXPECT_NE(findings("host_sim/world/a.cpp", "#include \"hal/replay/a.hpp\""), "");
}

TEST(Floors, ImplementationsOfThePortsShareWhatLiesBelowThem) {
  constexpr std::string_view kShared = "#include \"hal/posix/a.hpp\"\n#include \"hal/capture/a.hpp\"\n";
  EXPECT_EQ(findings("hal/v4l2/a.cpp", kShared), "");
  EXPECT_NE(findings("hal/posix/a.cpp", "#include \"hal/v4l2/a.hpp\""), "");
  EXPECT_NE(findings("hal/capture/a.cpp", "#include \"hal/v4l2/a.hpp\""), "");
}

TEST(Floors, OnlyTheProgramsJoinEverything) {
  constexpr std::string_view kAll = "#include \"hal/replay/a.hpp\"\n#include \"static_models/mire/mire.hpp\"\n";
  EXPECT_EQ(findings("hal/app/main.cpp", kAll), "");
  EXPECT_EQ(findings("host_sim/main.cpp", kAll), "");
  EXPECT_NE(findings("hal/app/main.cpp", "#include \"host_sim/world/a.hpp\""), "");
}

TEST(Floors, NothingIncludesTestsAndOnlyTestsIncludeOpenCv) {
  EXPECT_NE(findings("host_sim/main.cpp", "#include \"tests/support/heap_trap.hpp\""), "");
  EXPECT_NE(findings("host_sim/main.cpp", "#include <opencv2/core.hpp>"), "");
  EXPECT_EQ(findings("tests/core/vision/a_test.cpp", "#include <opencv2/core.hpp>\n#include \"tests/support/a.hpp\""),
            "");
}

TEST(Floors, IncludesAreWrittenFromTheRootAndInTheOpen) {
  EXPECT_EQ(findings("core/math/a.hpp", "#include \"types.hpp\""),
            "core/math/a.hpp:1: \"types.hpp\" is not written from the root\n");
  EXPECT_NE(findings("core/math/a.hpp", "  #  include \"../model/model_table.hpp\""), "");
  EXPECT_NE(findings("core/math/a.hpp", "#include CONFIG_HEADER"), "");
}

}  // namespace
}  // namespace articam::architecture
