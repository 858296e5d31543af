/// @file  The finished page in a browser without a window, as a phone, a desk and a printer show it.
#include "host_sim/report/run_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "host_sim/report/camera_picture.hpp"
#include "host_sim/scenarios/paper.hpp"
#include "tests/host_sim/report/synthetic_run.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/support/run_program.hpp"

namespace articam::sim {
namespace {

namespace fs = std::filesystem;
using articam::test::run;

/// Loads the page into a frame of that width and writes what it measures there into its own body.
constexpr const char* kProbe = R"probe(<body>
<iframe id="page" src="report.html" style="border:0;width:WIDTHpx;height:900px"></iframe>
<script>
const frame = document.getElementById("page");
frame.onload = () => {
  const page = frame.contentDocument, width = page.documentElement.clientWidth;
  const all = selector => [...page.querySelectorAll(selector)];
  const outside = all("body *:not(svg *)").filter(e => e.getBoundingClientRect().right > width + 0.5);
  const drawn = all("figure svg").filter(e => e.clientWidth > 200 && e.clientHeight > 50);
  const shots = all(".film g.shot").filter(e => frame.contentWindow.getComputedStyle(e).visibility == "visible");
  document.body.innerHTML = `width ${width} scroll ${page.documentElement.scrollWidth} outside ${outside.length} ` +
      `figures ${all("figure").length} drawn ${drawn.length} shots ${shots.length}.`;
};
</script></body>
)probe";

class ReportInABrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (run("command -v gnuplot").exit_code != 0) GTEST_SKIP() << "the program gnuplot is not installed";
    if (run("command -v chromium").exit_code != 0) GTEST_SKIP() << "the browser chromium is not installed";
    fs::create_directories(folder_ / "figures");
    RunRecord record = test::late_run();
    record.rival_mode = "paper";
    record.pulled_joint = 0;
    const Crop crop{0, 0, 640, 480};
    const std::vector<std::uint8_t> pixels(640 * 480, 100);
    const Overlay overlay{{}, scene_markers<PaperScenario::Model>(PaperScenario::at(0).q), {}, "0 s"};
    const std::string shot = picture_layers({pixels.data(), 640, 480, 640}, PaperScenario::camera(), overlay, crop);
    const std::vector<std::string> shots(4, shot);
    const std::vector<Figure> pictures{{"film", "film", camera_film(shots, 0.2, crop)},
                                       {"still", "still", camera_picture(shot, crop)}};
    const auto write = [](const fs::path& path, const std::string& content) {
      return std::ofstream{path} << content ? std::string{} : "cannot write";
    };
    ASSERT_EQ(write_report(folder_, {record, pictures, test::pulls()}, evaluate(record), write), "");
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// What the browser says on standard output and error.
  std::string browse(const std::string& options, const std::string& page) const {
    return run("timeout 60 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars "
               "--allow-file-access-from-files "
               "--enable-logging=stderr --user-data-dir='" +
               (folder_ / "profile").string() + "' " + options + " 'file://" + (folder_ / page).string() + "'")
        .text;
  }

  const fs::path folder_ = articam::test::own_folder();
};

TEST_F(ReportInABrowser, FitsAPhoneAndADeskWithAllFiguresAndOneShotOfTheFilm) {
  for (const std::string width : {"360", "1200"}) {
    std::string probe = kProbe;
    probe.replace(probe.find("WIDTH"), 5, width);
    std::ofstream{folder_ / "probe.html"} << probe;
    const std::string said = browse("--window-size=1400,1000 --virtual-time-budget=3000 --dump-dom", "probe.html");
    // 2 pictures, 7 of the paper, the robot's, 3 counts.
    EXPECT_NE(said.find("width " + width + " scroll " + width + " outside 0 figures 13 drawn 13 shots 1."),
              std::string::npos)
        << said;
    EXPECT_EQ(said.find("CONSOLE"), std::string::npos) << said;
  }
}

TEST_F(ReportInABrowser, Prints) {
  const fs::path pdf = folder_ / "report.pdf";
  const std::string said = browse("--no-pdf-header-footer --print-to-pdf='" + pdf.string() + "'", "report.html");
  std::string head(5, ' ');
  std::ifstream{pdf}.read(head.data(), 5);
  EXPECT_EQ(head, "%PDF-") << said;
  if (run("command -v pdftotext").exit_code != 0) return;
  const std::string text = run("pdftotext '" + pdf.string() + "' -").text;
  for (const char* part : {"Scenario paper", "Figure 7.", "true claims", "More numbers"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace articam::sim
