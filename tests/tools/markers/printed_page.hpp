#pragma once
/// @file  A page as a printer would see it: rendered by other programs than those that drew it, as grey pixels.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/own_folder.hpp"
#include "tests/support/run_program.hpp"
#include "tools/markers/sheet_files.hpp"

namespace articam::test {

struct PrintedPage {
  int width_px{}, height_px{};
  double pixel_mm{};
  std::vector<std::uint8_t> grey;

  bool ok() const { return !grey.empty(); }

  /// 0 of bare paper to 1 of black, of the pixel (u, v).
  double dark(int u, int v) const {
    return 1 -
           grey[static_cast<std::size_t>(v) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(u)] / 255.0;
  }

  /// visit(x_mm, y_mm, dark) for every pixel whose centre lies in the box.
  void visit(const markers::Box& box, const std::function<void(double, double, double)>& visitor) const {
    const auto first = [this](double mm) { return static_cast<int>(std::ceil(mm / pixel_mm - 0.5)); };
    for (int v = first(box.y_mm); v < first(box.bottom_mm()); ++v) {
      for (int u = first(box.x_mm); u < first(box.right_mm()); ++u) {
        visitor((u + 0.5) * pixel_mm, (v + 0.5) * pixel_mm, dark(u, v));
      }
    }
  }
};

/// Nothing is read where the file is none of pdftoppm's: binary, 8 bits, without a comment.
inline PrintedPage read_page(const std::filesystem::path& pgm, double dpi) {
  PrintedPage page;
  std::ifstream stream(pgm, std::ios::binary);
  std::string magic;
  int maximum = 0;
  stream >> magic >> page.width_px >> page.height_px >> maximum;
  if (!stream || magic != "P5" || maximum != 255) return {};
  stream.get();
  page.pixel_mm = 25.4 / dpi;
  page.grey.resize(static_cast<std::size_t>(page.width_px) * static_cast<std::size_t>(page.height_px));
  stream.read(reinterpret_cast<char*>(page.grey.data()), static_cast<std::streamsize>(page.grey.size()));
  return stream ? page : PrintedPage{};
}

/// Whether the programs that render are here.
inline bool can_print(markers::Format format) {
  return run("command -v pdftoppm").exit_code == 0 &&
         (format == markers::Format::pdf || run("command -v rsvg-convert").exit_code == 0);
}

/// Draws the sheets and renders them by Poppler, those of SVG first by librsvg: one image a page; none on failure.
inline std::vector<PrintedPage> print(const markers::Sheets& sheets, markers::Format format, double dpi) {
  const auto folder = own_folder();
  std::filesystem::create_directories(folder);
  const std::string name = folder / (format == markers::Format::pdf ? "sheet.pdf" : "sheet.svg");
  std::string why;
  const auto files = markers::render(sheets, "model", name, format, why);
  std::vector<PrintedPage> pages;
  for (std::size_t i = 0; files && i < sheets.pages.size(); ++i) {
    const auto& file = (*files)[format == markers::Format::pdf ? 0 : i];
    std::ofstream(file.path, std::ios::binary) << file.bytes;
    std::string pdf = file.path, number = std::to_string(i + 1);
    if (format == markers::Format::svg) {
      pdf += ".pdf";
      number = "1";
      if (run("rsvg-convert -f pdf -o '" + pdf + "' '" + file.path + "'").exit_code != 0) break;
    }
    const std::string image = folder / "page";
    run("pdftoppm -gray -singlefile -f " + number + " -r " + std::to_string(dpi) + " '" + pdf + "' '" + image + "'");
    pages.push_back(read_page(image + ".pgm", dpi));
  }
  std::filesystem::remove_all(folder);
  return pages;
}

}  // namespace articam::test
