#include "tests/architecture/call_graph.hpp"

#include <gtest/gtest.h>

namespace articam::architecture {
namespace {

std::string node(const std::string& name, const std::string& frame) {
  return "node: { title: \"" + name + "\" label: \"int " + name + "()\\na.cpp:1:5\\n" + frame +
         "\\n0 dynamic objects\" }\n";
}
std::string outside(const std::string& name) {
  return "node: { title: \"" + name + "\" label: \"" + name + "\\n<built-in>\" shape : ellipse }\n";
}
std::string edge(const std::string& from, const std::string& to) {
  return "edge: { sourcename: \"" + from + "\" targetname: \"" + to + "\" label: \"a.cpp:2:3\" }\n";
}
std::string file(const std::string& rows) { return "graph: { title: \"a.cpp\"\n" + rows + "}\n"; }

WorstCase worst_of_root(const std::string& rows) {
  CallGraph graph;
  EXPECT_TRUE(graph.read(file(rows)));
  return graph.worst_case("root");
}

TEST(CallGraph, AddsTheFramesOfTheDeepestChain) {
  const auto worst =
      worst_of_root(node("root", "16 bytes (static)") + node("wide", "100 bytes (static)") +
                    node("low", "40 bytes (static)") + node("lower", "80 bytes (static)") + edge("root", "wide") +
                    edge("root", "low") + edge("low", "lower") + edge("root", "lower"));
  EXPECT_EQ(worst.bytes, 16 + 40 + 80);
  EXPECT_EQ(worst.path, (std::vector<std::string>{"16  int root()", "40  int low()", "80  int lower()"}));
  EXPECT_TRUE(worst.violations.empty());
}

TEST(CallGraph, JoinsObjectsByTheNamesOfTheLinker) {
  CallGraph graph;
  ASSERT_TRUE(graph.read(file(node("root", "16 bytes (static)") + edge("root", "far") + outside("far"))));
  ASSERT_TRUE(graph.read(file(node("b.cpp:far", "24 bytes (static)"))));
  const auto worst = graph.worst_case("root");
  EXPECT_EQ(worst.bytes, 16 + 24);
  EXPECT_TRUE(worst.violations.empty());
}

TEST(CallGraph, KnowsTheTwoNamesOfOneConstructor) {
  const auto worst = worst_of_root(node("root", "16 bytes (static)") + node("_ZN1AC2Ei", "8 bytes (static)") +
                                   edge("root", "_ZN1AC1Ei"));
  EXPECT_EQ(worst.bytes, 16 + 8);
  EXPECT_TRUE(worst.violations.empty());
}

TEST(CallGraph, CountsALibraryFunctionWithItsStatedFrame) {
  const auto worst = worst_of_root(node("root", "16 bytes (static)") + outside("sqrt") + edge("root", "sqrt"));
  EXPECT_EQ(worst.bytes, 16 + CallGraph::kLibraryFrame_bytes);
  EXPECT_TRUE(worst.violations.empty());
}

TEST(CallGraph, APlantedRecursionIsFoundThroughAnyNumberOfFunctions) {
  const std::string chain = node("root", "16 bytes (static)") + node("a", "8 bytes (static)") +
                            node("b", "8 bytes (static)") + edge("root", "a") + edge("a", "b");
  EXPECT_TRUE(worst_of_root(chain).violations.empty());
  EXPECT_EQ(worst_of_root(chain + edge("b", "a")).violations, std::vector<std::string>{"recursion: int a()"});
  EXPECT_EQ(worst_of_root(chain + edge("a", "a")).violations, std::vector<std::string>{"recursion: int a()"});
  EXPECT_EQ(worst_of_root(chain + edge("b", "root")).violations, std::vector<std::string>{"recursion: int root()"});
}

TEST(CallGraph, APlantedFrameOfUnknownSizeIsFound) {
  EXPECT_EQ(worst_of_root(node("root", "16 bytes (dynamic)")).violations,
            std::vector<std::string>{"frame of a size that only run time knows: int root()"});
  EXPECT_TRUE(worst_of_root(node("root", "16 bytes (dynamic,bounded)")).violations.empty()) << "a maximum is known";
}

TEST(CallGraph, APlantedCallThroughAPointerIsFound) {
  EXPECT_EQ(worst_of_root(node("root", "16 bytes (static)") + edge("root", "__indirect_call")).violations,
            std::vector<std::string>{"call through a pointer, in int root()"});
}

TEST(CallGraph, APlantedCallOfAFunctionThatNobodyDefinesIsFound) {
  EXPECT_EQ(worst_of_root(node("root", "16 bytes (static)") + outside("malloc") + edge("root", "malloc")).violations,
            std::vector<std::string>{"nobody defines malloc"});
}

TEST(CallGraph, RefusesAFileThatIsNone) {
  CallGraph graph;
  EXPECT_FALSE(graph.read(""));
  EXPECT_FALSE(graph.read("int main() {}\n"));
  EXPECT_FALSE(graph.read("graph: { title: \"a.cpp\"\nnode: { title: \"cut\n"));
}

}  // namespace
}  // namespace articam::architecture
