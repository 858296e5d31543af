#pragma once
/// @file  URDF text -> its <robot> element, after everything that could harm a parser was refused.

#include <tinyxml2.h>

#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/source_file.hpp"

namespace articam::modelgen {

/// The outermost element, owned by the document; a namespace's prefix of it is taken off every name.
/// Null after having said what is wrong: a DTD, tags or nesting beyond the limits of read_urdf.hpp, not well-formed
/// XML, or not one <robot>.
tinyxml2::XMLElement* parse_robot(const SourceFile& source, tinyxml2::XMLDocument& document, Diagnostics& diagnostics);

}  // namespace articam::modelgen
