#pragma once
/// @file  Sheets -> files: their names and bytes.

#include <optional>
#include <string>
#include <vector>

#include "tools/markers/layout.hpp"
#include "tools/modelgen/output_files.hpp"

namespace articam::markers {

enum class Format { pdf, svg };

/// By the end of the name, .pdf or .svg; nothing for another.
std::optional<Format> format_of(const std::string& path);

/// PDF: one file of all pages. SVG has no pages: `path` itself for one page, otherwise one file a page, door.svg
/// becoming door-1.svg, door-2.svg and so on. The bytes hold no date: they are the same in every run with the same
/// cairo and fonts. Errors  nothing when cairo fails; `why` is then its message.
std::optional<std::vector<modelgen::OutputFile>> render(const Sheets& sheets, const std::string& title,
                                                        const std::string& path, Format format, std::string& why);

}  // namespace articam::markers
