#pragma once
/// @file  The worst-case stack of a function, from the call graph that GCC writes beside each object.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace articam::architecture {

/// What a call of one function can need, and why that cannot be relied on.
struct WorstCase {
  long bytes{};                         ///< of the deepest chain of calls, its own frame included
  std::vector<std::string> path;        ///< that chain, `frame bytes  function` each
  std::vector<std::string> violations;  ///< of any function that can be reached; sorted
};

/// The functions of any number of objects, joined by name.
///
/// A frame is the compiler's figure (-fcallgraph-info=su,da). Functions that no graph defines must be in the list of
/// the C library's and the compiler's own, each of which is taken to need kLibraryFrame_bytes. Violations are
/// recursion, frames whose size is known at run time only, calls through pointers, and callees that nobody defines.
/// Source  GCC manual, "Developer Options", -fcallgraph-info.
class CallGraph {
 public:
  /// More than the deepest of newlib and libgcc: sqrt in software, 80 bytes with what it calls.
  static constexpr long kLibraryFrame_bytes = 128;

  /// Adds the text of one .ci file. False when it is not one.
  bool read(const std::string& text);

  /// The functions whose readable name contains the words, and their names in the graph.
  std::map<std::string, std::string> find(std::string_view words) const;

  /// `name` as find() gives it.
  WorstCase worst_case(const std::string& name) const;

 private:
  struct Function {
    std::string readable;
    long frame_bytes{-1};  ///< -1: called, not defined here
    bool dynamic{};
    std::vector<std::string> calls;
  };
  class Walk;

  const Function* definition(const std::string& name) const;

  std::map<std::string, Function> functions_;
  std::map<std::string, std::string> files_of_;  ///< linker's name -> name in the graph, `file:name` for local ones
};

}  // namespace articam::architecture
