#pragma once
/// @file  Names of a URDF, which may be any text -> names of C++ code.

#include <string>
#include <vector>

namespace articam::modelgen {

/// kPascalCase of every name, in order: letters and digits stay, every other run of signs ends a word (and stays as one
/// underscore between digits, so that 1_1 is not 11). The k keeps clear of keywords, macros and reserved names. A name
/// without any letter or digit becomes kKIND and its number. Where two come out alike, the later one gets its number.
std::vector<std::string> to_identifiers(const std::vector<std::string>& names, const std::string& kind);

}  // namespace articam::modelgen
