#pragma once
/// @file  Small rules that keep every file readable.

#include "tests/architecture/source_tree.hpp"

namespace articam::architecture {

inline constexpr int kMaxLines = 300;
inline constexpr int kMaxColumns = 120;

/// Too long, too wide, a tab, blanks at a line's end, a missing last newline, a header without
/// `#pragma once`, a note of work left undone, or a file name that says nothing.
Violations check_hygiene(const SourceFile& file);

}  // namespace articam::architecture
