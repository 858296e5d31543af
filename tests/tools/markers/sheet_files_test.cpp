#include "tools/markers/sheet_files.hpp"

#include <gtest/gtest.h>

namespace articam::markers {
namespace {

using model::MarkerKind;

Sheets sheets_of(std::size_t count, const std::string& name = "link") {
  return lay_out(std::vector<Mark>(count, {name, MarkerKind::ring, 50, 20}), kPapers[1], 10).value();
}

std::vector<modelgen::OutputFile> rendered(const Sheets& sheets, const std::string& path,
                                           const std::string& title = "model") {
  std::string why;
  return render(sheets, title, path, *format_of(path), why).value();
}

TEST(SheetFiles, AreOnePdfOfAllPagesButOneSvgAPage) {
  const Sheets one = sheets_of(1), two = sheets_of(6);
  ASSERT_EQ(two.pages.size(), 2u);
  EXPECT_EQ(rendered(two, "a/door.pdf").size(), 1u);
  EXPECT_EQ(rendered(one, "a/door.svg").at(0).path, "a/door.svg");
  const auto files = rendered(two, "a/v1.2/door.svg");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].path, "a/v1.2/door-1.svg");
  EXPECT_EQ(files[1].path, "a/v1.2/door-2.svg");
  EXPECT_NE(files[0].bytes, files[1].bytes);
}

TEST(SheetFiles, TakeNamesOfAnyScriptAndLength) {
  for (const std::string& name :
       {std::string{"poign\xC3\xA9"
                    "e"},
        std::string{"\xE6\x8A\x8A\xE6\x89\x8B"}, std::string{"<&\">'%s\\"}, std::string(1000, 'W'), std::string{}}) {
    for (const char* path : {"door.pdf", "door.svg"}) {
      EXPECT_GT(rendered(sheets_of(1, name), path, name).at(0).bytes.size(), 1000u) << name;
    }
  }
}

TEST(SheetFiles, TellCairosReasonWhenTextIsBroken) {
  std::string why;
  EXPECT_FALSE(render(sheets_of(1, "\xFF"), "model", "door.pdf", Format::pdf, why));
  EXPECT_NE(why, "");
}

TEST(SheetFiles, KnowTheirFormatByTheEndOfTheName) {
  EXPECT_EQ(format_of("a.b/door.pdf"), Format::pdf);
  EXPECT_EQ(format_of("door.svg"), Format::svg);
  for (const char* path : {"door", "door.png", "door.pdf.txt", ".pdf", "a.pdf/door", ""}) {
    EXPECT_EQ(format_of(path), std::nullopt) << path;
  }
}

}  // namespace
}  // namespace articam::markers
