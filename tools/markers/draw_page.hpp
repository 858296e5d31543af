#pragma once
/// @file  One page, drawn to scale.

#include <cairo.h>

#include <cstddef>
#include <string>

#include "tools/markers/layout.hpp"

namespace articam::markers {

/// Draws page `i_page` of the sheets. The cairo context's unit must be the mm, its origin the page's top left corner.
/// `title` names the model. Characters that the machine's sans-serif font lacks appear as boxes.
void draw_page(cairo_t* cairo, const Sheets& sheets, std::size_t i_page, const std::string& title);

}  // namespace articam::markers
