#include "tools/markers/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace articam::markers {
namespace {

constexpr double kHeader_mm = 8, kFooter_mm = 26;

/// A row of pieces on a page, as high as its first one.
struct Shelf {
  std::size_t page{};
  double y_mm{}, height_mm{};
  double used_mm{};
};

double width_mm(const Mark& mark) { return std::max(square_mm(mark) + 2 * kCropZone_mm, kLeastWidth_mm); }
double height_mm(const Mark& mark) { return square_mm(mark) + 2 * kCropZone_mm + kLabel_mm; }

bool fits(const Mark& mark, const Box& room) {
  return width_mm(mark) <= room.width_mm && height_mm(mark) <= room.height_mm;
}

bool fits(const Mark& mark, const Paper& paper, double margin_mm) {
  return fits(mark, Sheets{paper, margin_mm, {}}.content()) ||
         fits(mark, Sheets{paper.turned(), margin_mm, {}}.content());
}

/// Opens a shelf below the last one, on a new page where there is no room.
Shelf& open_shelf(double height, const Box& room, std::vector<Shelf>& shelves) {
  Shelf next{0, room.y_mm, height, 0};
  if (!shelves.empty()) {
    next.page = shelves.back().page;
    next.y_mm = shelves.back().y_mm + shelves.back().height_mm;
    if (next.y_mm + height > room.bottom_mm()) next = {next.page + 1, room.y_mm, height, 0};
  }
  return shelves.emplace_back(next);
}

/// Nothing when a mark does not fit on the paper as it lies. `marks`: larger ones first.
std::optional<Sheets> pack(std::span<const Mark> marks, const Paper& paper, double margin_mm) {
  Sheets sheets{paper, margin_mm, {}};
  const Box room = sheets.content();
  std::vector<Shelf> shelves;
  for (const Mark& mark : marks) {
    if (!fits(mark, room)) return std::nullopt;
    const double width = width_mm(mark);
    const auto with_room =
        std::ranges::find_if(shelves, [&](const Shelf& shelf) { return shelf.used_mm + width <= room.width_mm; });
    Shelf& shelf = with_room != shelves.end() ? *with_room : open_shelf(height_mm(mark), room, shelves);
    if (shelf.page >= sheets.pages.size()) sheets.pages.emplace_back();
    sheets.pages[shelf.page].push_back(
        {mark, room.x_mm + shelf.used_mm + width / 2, shelf.y_mm + kCropZone_mm + square_mm(mark) / 2});
    shelf.used_mm += width;
  }
  return sheets;
}

}  // namespace

Box Piece::square() const {
  const double side = square_mm(mark);
  return {x_mm - side / 2, y_mm - side / 2, side, side};
}

Box Piece::label() const {
  const Box all = box();
  return {all.x_mm, all.bottom_mm() - kLabel_mm, all.width_mm, kLabel_mm};
}

Box Piece::box() const {
  const double width = width_mm(mark);
  return {x_mm - width / 2, square().y_mm - kCropZone_mm, width, height_mm(mark)};
}

Box Sheets::printable() const {
  return {margin_mm, margin_mm, paper.width_mm - 2 * margin_mm, paper.height_mm - 2 * margin_mm};
}

Box Sheets::header() const {
  const Box all = printable();
  return {all.x_mm, all.y_mm, all.width_mm, kHeader_mm};
}

Box Sheets::content() const {
  const Box all = printable();
  return {all.x_mm, all.y_mm + kHeader_mm, all.width_mm, all.height_mm - kHeader_mm - kFooter_mm};
}

Box Sheets::footer() const {
  const Box all = printable();
  return {all.x_mm, all.bottom_mm() - kFooter_mm, all.width_mm, kFooter_mm};
}

Box Sheets::ruler() const {
  constexpr double kHeight_mm = 5, kNumbers_mm = 4;
  const Box all = footer();
  return {all.x_mm, all.bottom_mm() - kNumbers_mm - kHeight_mm, kRuler_mm, kHeight_mm};
}

std::optional<Sheets> lay_out(std::span<const Mark> marks, const Paper& paper, double margin_mm) {
  std::vector<Mark> sorted(marks.begin(), marks.end());
  std::ranges::stable_sort(sorted, std::greater{}, &Mark::outer_mm);
  auto upright = pack(sorted, paper, margin_mm);
  auto turned = pack(sorted, paper.turned(), margin_mm);
  const bool turn = turned && (!upright || turned->pages.size() < upright->pages.size());
  return turn ? turned : upright;
}

std::vector<std::string> objections(std::span<const Mark> marks, const Paper& paper, double margin_mm) {
  std::vector<std::string> reasons;
  for (const Mark& mark : marks) {
    if (fits(mark, paper, margin_mm)) continue;
    const auto larger = std::ranges::find_if(kPapers, [&](const Paper& p) { return fits(mark, p, margin_mm); });
    const std::string remedy = larger == kPapers.end()
                                   ? "too large for every paper; check its diameter, it is in m"
                                   : fmt::format("use --paper {}, or a smaller --margin", larger->name);
    reasons.push_back(fmt::format("marker '{}' needs {:.0f} x {:.0f} mm within the margins of {}: {}", mark.name,
                                  width_mm(mark), height_mm(mark), paper.name, remedy));
  }
  return reasons;
}

}  // namespace articam::markers
