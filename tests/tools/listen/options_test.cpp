#include "tools/listen/options.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace articam::listen {
namespace {

using Host = std::array<std::uint8_t, 4>;

std::optional<int> parse(std::vector<const char*> arguments, Options& out) {
  arguments.insert(arguments.begin(), "articam-listen");
  return parse_options(static_cast<int>(arguments.size()), arguments.data(), out);
}

TEST(Options, WithoutAnyListenToTheGroupThatABoardSendsToAndPrint) {
  Options options;
  EXPECT_EQ(parse({}, options), std::nullopt);
  EXPECT_EQ(options.from.port, wire::kDefaultPort);
  EXPECT_EQ(options.from.host, (Host{239, 255, 47, 47}));
  EXPECT_FALSE(options.quiet || options.json || options.overwrite);
  EXPECT_EQ(options.count, 0u);
}

TEST(Options, SendJsonToThisMachineAndPlotJugglersPortUnlessToldOtherwise) {
  const auto json = [](std::vector<const char*> arguments) {
    Options options;
    EXPECT_EQ(parse(arguments, options), std::nullopt);
    return options.json.value_or(wire::Address{});
  };
  EXPECT_EQ(json({"--json-udp"}).port, 9870);
  EXPECT_EQ(json({"--json-udp", "--quiet"}).host, (Host{127, 0, 0, 1}));
  EXPECT_EQ(json({"--json-udp", "5000"}).port, 5000);
  EXPECT_EQ(json({"--json-udp", "5000"}).host, (Host{127, 0, 0, 1}));
  EXPECT_EQ(json({"--json-udp", "10.0.0.3"}).port, 9870);
  EXPECT_EQ(json({"--json-udp", "10.0.0.3:6000"}).host, (Host{10, 0, 0, 3}));
  EXPECT_EQ(json({"--json-udp", "10.0.0.3:6000"}).port, 6000);
}

TEST(Options, SayWhenToEnd) {
  Options options;
  EXPECT_EQ(parse({"--once", "--seconds", "2.5", "--timeout", "1"}, options), std::nullopt);
  EXPECT_EQ(options.count, 1u);
  EXPECT_EQ(options.seconds, 2.5);
  EXPECT_EQ(options.timeout_s, 1);
}

}  // namespace
}  // namespace articam::listen
