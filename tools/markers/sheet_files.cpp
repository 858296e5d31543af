#include "tools/markers/sheet_files.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "tools/markers/draw_page.hpp"

namespace articam::markers {
namespace {

constexpr double kPoint_mm = 25.4 / 72;  // cairo's unit

template <auto kFree>
struct FreedBy {
  template <class T>
  void operator()(T* owned) const {
    kFree(owned);
  }
};
using Surface = std::unique_ptr<cairo_surface_t, FreedBy<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, FreedBy<cairo_destroy>>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

Surface pdf_surface(const Paper& paper, const std::string& title, std::string& bytes) {
  Surface surface{
      cairo_pdf_surface_create_for_stream(append, &bytes, paper.width_mm / kPoint_mm, paper.height_mm / kPoint_mm)};
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, ("Markers of " + title).c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");  // otherwise the time of the run
  return surface;
}

Surface svg_surface(const Paper& paper, std::string& bytes) {
  Surface surface{
      cairo_svg_surface_create_for_stream(append, &bytes, paper.width_mm / kPoint_mm, paper.height_mm / kPoint_mm)};
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PT);
  return surface;
}

/// Draws these pages onto the surface and ends it. False when cairo fails.
bool draw(Surface surface, const Sheets& sheets, std::size_t first, std::size_t last, const std::string& title,
          std::string& why) {
  const Context cairo{cairo_create(surface.get())};
  cairo_scale(cairo.get(), 1 / kPoint_mm, 1 / kPoint_mm);
  for (std::size_t i_page = first; i_page < last; ++i_page) {
    cairo_save(cairo.get());
    draw_page(cairo.get(), sheets, i_page, title);
    cairo_restore(cairo.get());
    cairo_show_page(cairo.get());
  }
  cairo_surface_finish(surface.get());
  cairo_status_t status = cairo_status(cairo.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) why = cairo_status_to_string(status);
  return status == CAIRO_STATUS_SUCCESS;
}

/// door.svg, 2 -> door-2.svg
std::string numbered(const std::filesystem::path& path, std::size_t number) {
  std::filesystem::path name = path.stem();
  name += fmt::format("-{}", number);
  name += path.extension();
  return (path.parent_path() / name).string();
}

}  // namespace

std::optional<Format> format_of(const std::string& path) {
  const auto extension = std::filesystem::path(path).extension();
  if (extension == ".pdf") return Format::pdf;
  if (extension == ".svg") return Format::svg;
  return std::nullopt;
}

using modelgen::OutputFile;

std::optional<std::vector<OutputFile>> render(const Sheets& sheets, const std::string& title, const std::string& path,
                                              Format format, std::string& why) {
  const std::size_t num_pages = sheets.pages.size();
  std::vector<OutputFile> files;
  if (format == Format::pdf) {
    OutputFile& file = files.emplace_back(OutputFile{path, {}});
    if (!draw(pdf_surface(sheets.paper, title, file.bytes), sheets, 0, num_pages, title, why)) return std::nullopt;
    return files;
  }
  for (std::size_t i = 0; i < num_pages; ++i) {
    OutputFile file{num_pages == 1 ? path : numbered(path, i + 1), {}};
    if (!draw(svg_surface(sheets.paper, file.bytes), sheets, i, i + 1, title, why)) return std::nullopt;
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace articam::markers
