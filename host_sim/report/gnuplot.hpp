#pragma once
/// @file  Drawings by the program gnuplot.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/status.hpp"
#include "host_sim/report/figure.hpp"

namespace articam::sim {

/// One colour and one dash for each, in every figure; told apart in grey, too. Styles of gnuplot.
inline constexpr std::string_view kTruth = "linewidth 4 linecolor rgb '#bdbdbd'";
inline constexpr std::string_view kDefault = "linewidth 1.4 linecolor rgb '#0072b2'";
inline constexpr std::string_view kPaper = "linewidth 1.2 linecolor rgb '#009e73' pointtype 8 pointsize 0.7";
inline constexpr std::string_view kSvd = "linewidth 1.1 dashtype 2 linecolor rgb '#d55e00'";
inline constexpr std::string_view kCommand = "linewidth 1.2 dashtype 4 linecolor rgb '#202020'";
inline constexpr std::string_view kBandLine = "linewidth 7 linecolor rgb '#b5d5ea'";  ///< of a band, in a key
inline constexpr std::string_view kBand = "fillcolor rgb '#b5d5ea' fillstyle solid noborder";

/// A figure before it is drawn. It is kWidth_px wide, which keeps its letters readable on a phone.
struct Plan {
  std::string name, caption;
  int height_px{};
  std::string data;  ///< gnuplot's data blocks; later plans know them too
  std::string body;
};
inline constexpr int kWidth_px = 560;

struct Range {
  double low{}, high{};
};

/// `set NAMEtics` with a step of 1, 2 or 5 times a power of ten that puts at most `most` of them into the range.
std::string tics(std::string_view axis, const Range& range, int most);

/// One line of a figure's key.
struct KeyEntry {
  std::string title, style;  ///< style: of gnuplot, from `with` on
};
inline constexpr int kKey_px = 30;

/// The first diagram of a multiplot: the key alone, across the figure's top kKey_px.
std::string key_strip(std::span<const KeyEntry> entries, int height_px);

/// A diagram's own label, upright at the left edge; gnuplot's would wander with the width of the numbers.
std::string upright(const std::string& label, double centre);

/// A place for one diagram inside a figure, as parts of its width and height from its lower left corner.
std::string place(double left, double right, double bottom, double top);

/// One run of gnuplot for all. Replaces `figures`.
/// Errors  io_error when the program is missing or fails.
Status draw(std::span<const Plan> plans, std::vector<Figure>& figures);

}  // namespace articam::sim
