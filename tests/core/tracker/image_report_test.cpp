#include "core/tracker/image_report.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace articam {
namespace {

using tracker::blame_image;
using tracker::Reason;

const std::vector<std::uint8_t> kBlack(64 * 64, 5), kGrey(64 * 64, 128);
ImageView view(const std::vector<std::uint8_t>& pixels) { return {pixels.data(), 64, 64, 64}; }

/// Marks of which the first ones have that flaw.
vision::Detections marks(int n, int flawed, std::uint8_t flaw) {
  vision::Detections all;
  for (int i = 0; i < n; ++i) {
    vision::Detection mark;
    mark.flaws = i < flawed ? flaw : std::uint8_t{0};
    (void)all.push_back(mark);
  }
  return all;
}

TEST(ImageReport, IsBlamedForMissingMarks) {
  EXPECT_EQ(blame_image(view(kBlack), marks(3, 0, 0), 6), Reason::underexposed);
  EXPECT_EQ(blame_image(view(kBlack), marks(0, 0, 0), 6), Reason::underexposed);
  EXPECT_EQ(blame_image(view(kGrey), marks(3, 0, 0), 6), Reason::none);
}

TEST(ImageReport, IsNotBlamedWhereAllMarksAreSeenWell) {
  EXPECT_EQ(blame_image(view(kBlack), marks(6, 0, 0), 6), Reason::none);
}

TEST(ImageReport, IsWhatMostOfItsMarksSay) {
  EXPECT_EQ(blame_image(view(kGrey), marks(6, 4, vision::kSaturated), 6), Reason::overexposed);
  EXPECT_EQ(blame_image(view(kGrey), marks(6, 4, vision::kBlurred), 6), Reason::blurred);
  EXPECT_EQ(blame_image(view(kGrey), marks(6, 3, vision::kBlurred), 6), Reason::none);
  EXPECT_EQ(blame_image(view(kGrey), marks(6, 6, vision::kClipped), 6), Reason::none);  // black ink may be black
}

}  // namespace
}  // namespace articam
