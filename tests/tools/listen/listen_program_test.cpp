/// @file  articam-listen from outside: packets over loopback in, lines, files, JSON and exit codes out.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/own_folder.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/udp_ear.hpp"
#include "tests/tools/listen/heard_estimate.hpp"
#include "tests/tools/listen/mcap_reader.hpp"
#include "tools/listen/csv_output.hpp"

namespace articam::listen {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ifstream stream{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

class ListenProgram : public testing::Test {
 protected:
  ListenProgram() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    model_.session = 1;
    for (std::uint32_t number = 0; number < 20; ++number) {
      estimates_.push_back(test::MadeUp{random_}.estimate);
      auto& e = estimates_.back();
      e.session = 1, e.model_hash = model_.model_hash, e.number = e.frame = number;
      if (number % 5 == 4) test::make_invalid(e);
    }
  }
  ~ListenProgram() override {
    if (child_ > 0) ::kill(child_, SIGKILL), ::waitpid(child_, nullptr, 0);
    fs::remove_all(folder_);
  }

  /// Starts it, and waits until its port is open.
  void start(const std::string& arguments, const std::string& to = "out") {
    const std::string command =
        "exec " ARTICAM_LISTEN " --udp 127.0.0.1:" + std::to_string(port_) + " " + arguments + " > " + to + " 2>&1";
    child_ = ::fork();
    if (child_ == 0) {
      ::chdir(folder_.c_str());
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    const std::string port = hex_port();
    for (int i = 0; i < 1000 && read_file("/proc/net/udp").find(port) == std::string::npos; ++i) ::usleep(10'000);
  }
  /// As the kernel's table of sockets writes 127.0.0.1 and the port.
  std::string hex_port() const {
    char text[16];
    std::snprintf(text, sizeof text, "0100007F:%04X", unsigned{port_});
    return text;
  }
  void say(const test::Bytes& packet) const { ASSERT_TRUE(mouth_.say(packet, port_)); }
  void say_all() const {
    for (const auto& estimate : estimates_) {
      say(test::packet_of(estimate));
      if (estimate.number == 7) say(test::packet_of(model_));  // the names come late
    }
  }
  /// Ends it by that signal, or waits for its own end when it is 0.
  int end(int signal) {
    int status = 0;
    if (signal != 0) ::kill(child_, signal);
    ::waitpid(std::exchange(child_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string out() const { return read_file(folder_ / "out"); }
  void wait_for(const fs::path& file, const std::string& words) const {
    for (int i = 0; i < 1000 && read_file(folder_ / file).find(words) == std::string::npos; ++i) ::usleep(10'000);
    ASSERT_NE(read_file(folder_ / file).find(words), std::string::npos) << words << '\n' << out();
  }
  std::string expected_csv() const {
    std::string text = csv_header(model_) + '\n';
    for (const auto& estimate : estimates_) text += csv_row(estimate, 2) + '\n';
    return text;
  }
  void expect(const std::string& arguments, int exit_code, const std::string& words) const {
    const auto ended = test::run("cd " + folder_.string() + " && " ARTICAM_LISTEN " " + arguments);
    EXPECT_EQ(ended.exit_code, exit_code) << arguments << '\n' << ended.text;
    EXPECT_NE(ended.text.find(words), std::string::npos) << arguments << '\n' << ended.text;
  }

  const fs::path folder_ = test::own_folder();
  test::Random random_{41};
  const test::UdpEar mouth_;
  const std::uint16_t port_ = test::UdpEar{}.port();  // free a moment ago
  wire::ModelMessage model_ = test::random_model(random_);
  std::vector<wire::EstimateMessage> estimates_;
  pid_t child_{-1};
};

TEST_F(ListenProgram, RecordsAndForwardsEveryEstimateOnce) {
  const test::UdpEar plotter;
  start("--count 20 --timeout 20 --csv e.csv --mcap e.mcap --json-udp " + std::to_string(plotter.port()));
  say_all();
  EXPECT_EQ(end(0), 0) << out();
  EXPECT_EQ(read_file(folder_ / "e.csv"), expected_csv());
  const std::string bytes = read_file(folder_ / "e.mcap");
  const test::McapFile mcap{bytes};
  EXPECT_TRUE(mcap.closed);
  std::uint32_t number = 0;
  for (const auto& record : mcap.records) {
    test::ByteReader reader{record.content};
    if (record.opcode != 5 || reader.number<std::uint16_t>() != 1) continue;
    EXPECT_EQ(reader.number<std::uint32_t>(), number++) << "/articam/estimate";
  }
  EXPECT_EQ(number, 20u);
  for (const auto& estimate : estimates_) {
    const auto datagram = plotter.hear();
    const auto json = nlohmann::json::parse(datagram.begin(), datagram.end());
    EXPECT_EQ(json["number"], estimate.number);
    if (estimate.valid) {
      EXPECT_EQ(json["joints"]["joint_0"], estimate.joints[0]);
    }
  }
  EXPECT_NE(out().find("frame 19"), std::string::npos) << out();
  EXPECT_NE(out().find("received    20"), std::string::npos) << out();
}

TEST_F(ListenProgram, TellsLossDuplicatesAndBadPackets) {
  start("--quiet --csv e.csv");
  say(test::packet_of(model_));
  for (const std::size_t i : {0u, 1u, 1u, 4u, 3u}) say(test::packet_of(estimates_[i]));
  auto torn = test::packet_of(estimates_[5]);
  torn.pop_back();
  say(torn);
  say({'h', 'i'});
  say(test::packet_of(estimates_[6]));
  wait_for("e.csv", "\n6,");
  EXPECT_EQ(end(SIGINT), 0);
  EXPECT_NE(out().find("received    5\nlost        2 (28.571 %)\nduplicates  1\nreordered   1\n"
                       "bad         2: foreign 1, wrong_checksum 1\nsessions    1\n"),
            std::string::npos)
      << out();
  EXPECT_NE(out().find("one machine, one clock"), std::string::npos) << out();
}

TEST_F(ListenProgram, EndsItsFilesOnSigtermAndKeepsThemWhenKilled) {
  for (const int signal : {SIGTERM, SIGKILL}) {
    start("--quiet --overwrite --csv e.csv --mcap e.mcap");
    say_all();
    wait_for("e.csv", "\n19,");
    EXPECT_EQ(end(signal), signal == SIGTERM ? 0 : -1) << out();
    EXPECT_EQ(read_file(folder_ / "e.csv"), expected_csv());
    const std::string bytes = read_file(folder_ / "e.mcap");
    const test::McapFile mcap{bytes};
    EXPECT_EQ(mcap.closed, signal == SIGTERM);
    EXPECT_FALSE(mcap.torn);
    EXPECT_GE(mcap.records.size(), 1 + 2 * 4 + 19u);
  }
}

TEST_F(ListenProgram, EndsWithOneWhereNothingOrTooLittleIsHeard) {
  const std::string here = "--udp 127.0.0.1:" + std::to_string(port_) + " ";
  expect(here + "--timeout 0.1", 1, "nothing was heard");
  expect(here + "--seconds 0.1", 1, "nothing was heard");
  start("--quiet --count 21 --timeout 1");
  say_all();
  EXPECT_EQ(end(0), 1);
  EXPECT_NE(out().find("fewer estimates came than --count asks for"), std::string::npos) << out();
}

TEST_F(ListenProgram, EndsWithOneWhereAnOutputFailsAndKeepsTheOthers) {
  const std::string here = "--udp 127.0.0.1:" + std::to_string(port_) + " --timeout 0.1 ";
  std::ofstream{folder_ / "old.csv"} << "kept";
  expect(here + "--csv old.csv", 1, "old.csv: exists");
  EXPECT_EQ(read_file(folder_ / "old.csv"), "kept");
  expect(here + "--mcap /dev/null --overwrite", 1, "only a plain file is replaced");
  expect(here + "--csv no/folder/e.csv", 1, "no/folder/e.csv");
  expect(here + "--csv e.csv --mcap old.csv", 1, "old.csv: exists");
  EXPECT_FALSE(fs::exists(folder_ / "e.csv")) << "an empty file stayed behind";
  start("--csv e.csv --count 20", "/dev/full");
  say_all();
  EXPECT_EQ(end(0), 1);
  EXPECT_EQ(read_file(folder_ / "e.csv"), expected_csv());
}

TEST_F(ListenProgram, EndsWithTwoOnWrongUsage) {
  for (const char* arguments : {"--udp host:1", "--udp 239.1.1.1:0", "--serial ttyS1", "--udp 1 --serial /dev/ttyS1",
                                "--json-udp nowhere", "--t0 never --csv e.csv", "--count 0", "--count 2 --once",
                                "--seconds -1", "--timeout x", "--key-state s", "extra"}) {
    expect(arguments, 2, "--help");
  }
  EXPECT_FALSE(fs::exists(folder_ / "e.csv"));
}

TEST_F(ListenProgram, TeachesItsUse) {
  expect("--help", 0, "Examples");
  expect("--help", 0, "Exit codes");
  expect("--version", 0, "articam-listen");
  expect("--serial /dev/null", 1, "/dev/null");
  expect("--key absent.key", 1, "absent.key");
}

}  // namespace
}  // namespace articam::listen
