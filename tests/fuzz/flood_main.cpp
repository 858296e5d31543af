// articam-flood: a flood of packets for a port of this machine, to see that the estimator does not mind.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "hal/wire/address.hpp"

namespace {

using Clock = std::chrono::steady_clock;

struct Flood {
  std::string to;
  double rate{100'000};  // packets a second
  double seconds{5};
  std::size_t size{600};
};

void declare(CLI::App& app, Flood& flood) {
  app.add_option("--to", flood.to, "A port of this machine, 127.x.x.x:PORT")->required();
  app.add_option("--rate", flood.rate, "Packets a second")->check(CLI::Range(1.0, 1e6))->capture_default_str();
  app.add_option("--seconds", flood.seconds, "How long")->check(CLI::Range(0.01, 60.0))->capture_default_str();
  app.add_option("--size", flood.size, "Bytes of a packet")->check(CLI::Range(1, 9000))->capture_default_str();
  app.set_version_flag("--version", "articam-flood " ARTICAM_VERSION);
  app.footer(
      "Sends to loopback only. Prints how many packets went out.\n"
      "Example: what a receiver on the usual port makes of it\n"
      "  articam-flood --to 127.0.0.1:47047 --rate 100000 --seconds 5\n"
      "Exit codes: 0 done, 1 the packets cannot be sent, 2 wrong usage.");
}

/// Packets sent; what a full queue refuses is lost, as in any flood. Not connected: a port where nobody listens would
/// refuse every other packet.
std::uint64_t pour(int socket, const sockaddr_in& to, const Flood& flood) {
  const std::vector<char> packet(flood.size, 'x');
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  std::uint64_t tried = 0, sent = 0;
  for (double t = 0; t < flood.seconds; t = passed()) {
    for (const double due = t * flood.rate; static_cast<double>(tried) < due; ++tried) {
      const ssize_t size = ::sendto(socket, packet.data(), packet.size(), MSG_DONTWAIT,
                                    reinterpret_cast<const sockaddr*>(&to), sizeof to);
      sent += size > 0 ? 1u : 0u;
    }
    std::this_thread::sleep_for(std::chrono::microseconds{200});
  }
  return sent;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Floods a port of this machine with packets that mean nothing."};
  Flood flood;
  declare(app, flood);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? 0 : 2;
  }
  articam::wire::Address address;
  const auto problem = articam::wire::parse_address("udp://" + flood.to, address);
  if (!problem.empty() || address.host[0] != 127) {
    std::fprintf(stderr, "--to %s: %s\n", flood.to.c_str(),
                 problem.empty() ? "only this machine may be flooded: 127.x.x.x:PORT" : std::string{problem}.c_str());
    return 2;
  }
  sockaddr_in to{};
  to.sin_family = AF_INET, to.sin_port = htons(address.port);
  std::copy(address.host.begin(), address.host.end(), reinterpret_cast<std::uint8_t*>(&to.sin_addr));
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket < 0) {
    std::perror("articam-flood");
    return 1;
  }
  const std::uint64_t sent = pour(socket, to, flood);
  ::close(socket);
  std::printf("%llu packets in %g s, %.0f a second\n", static_cast<unsigned long long>(sent), flood.seconds,
              static_cast<double>(sent) / flood.seconds);
  return sent > 0 ? 0 : 1;
}
