#pragma once
/// @file  An input as bytes, with the hash that a generated header quotes.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "tools/modelgen/diagnostics.hpp"

namespace articam::modelgen {

struct SourceFile {
  std::string path;  ///< as the user named it
  std::string bytes;

  std::string file_name() const;  ///< without its folders: says the same on every machine
  int line_of(std::size_t offset) const;
};

inline constexpr std::size_t kMaxSourceBytes = 1u << 20;

/// Offset of the first byte that is not text: not UTF-8, or a control character other than blanks and line ends. npos
/// where all of it is.
std::size_t find_non_text(std::string_view bytes);

/// Bytes that are a source.
/// Errors  empty, larger than kMaxSourceBytes, not text.
std::optional<SourceFile> make_source(SourceFile source, Diagnostics& diagnostics);

/// The same from a file. Errors  those, and what cannot be read.
std::optional<SourceFile> read_source(const std::string& path, Diagnostics& diagnostics);

/// SHA-256 in 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace articam::modelgen
