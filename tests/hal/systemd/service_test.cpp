#include "hal/systemd/service.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <string>

#include "tests/support/heap_trap.hpp"

namespace articam {
namespace {

constexpr std::int64_t kQuarter_ns = 500'000'000;  // of two seconds

/// A service manager that listens at an address without a file.
class Service : public testing::Test {
 protected:
  Service() {
    const std::string name = "articam-service-test-" + std::to_string(::getpid());
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data(), name.size());
    socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0) << std::strerror(errno);
    ::setenv("NOTIFY_SOCKET", ("@" + name).c_str(), 1);
    ::setenv("WATCHDOG_USEC", "2000000", 1);
  }
  ~Service() override {
    ::close(socket_);
    for (const char* const name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) ::unsetenv(name);
  }

  /// Empty when there is nothing to hear.
  std::string heard() const {
    std::array<char, 64> words;
    const ssize_t size = ::recv(socket_, words.data(), words.size(), 0);
    return size > 0 ? std::string(words.data(), static_cast<std::size_t>(size)) : std::string{};
  }

 private:
  int socket_{-1};
};

TEST_F(Service, SaysThatItIsReadyAndThatItStops) {
  hal::Service service;
  service.tell_ready();
  service.tell_stopping();
  EXPECT_EQ(heard(), "READY=1");
  EXPECT_EQ(heard(), "STOPPING=1");
  EXPECT_EQ(heard(), "");
}

TEST_F(Service, FeedsTheWatchdogFourTimesInItsLimit) {
  hal::Service service;
  int fed = 0;
  for (std::int64_t t_ns = 1; t_ns < 4 * kQuarter_ns; t_ns += kQuarter_ns / 10) {
    service.feed_watchdog({t_ns});
    const std::string words = heard();
    if (words.empty()) continue;
    EXPECT_EQ(words, "WATCHDOG=1");
    ++fed;
  }
  EXPECT_EQ(fed, 4);
}

TEST_F(Service, NeverWaitsForAManagerWhoseQueueIsFullAndFeedsItWhenThereIsRoom) {
  hal::Service service;
  std::int64_t t_ns = 1;
  int queued = 0;
  for (int i = 0; i < 10'000; ++i) service.feed_watchdog({t_ns += kQuarter_ns});  // it would hang here
  service.tell_stopping();
  while (heard() == "WATCHDOG=1") ++queued;
  EXPECT_GT(queued, 0);
  EXPECT_LT(queued, 10'000) << "the queue never filled, nothing was shown";
  service.feed_watchdog({t_ns});  // at the same instant: the last one was not heard, so it is still due
  EXPECT_EQ(heard(), "WATCHDOG=1");
}

TEST_F(Service, DoesNotFeedAWatchdogThatWatchesAnotherProcess) {
  ::setenv("WATCHDOG_PID", "1", 1);
  hal::Service service;
  service.feed_watchdog({1});
  EXPECT_EQ(heard(), "");
}

TEST_F(Service, WithoutAManagerSaysNothing) {
  for (const char* const address : {"", "vsock:2:1", "relative/path"}) {
    ::setenv("NOTIFY_SOCKET", address, 1);
    hal::Service service;
    service.tell_ready();
    service.feed_watchdog({1});
    EXPECT_EQ(heard(), "");
  }
}

TEST_F(Service, FeedsTheWatchdogWithoutTheHeap) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  hal::Service service;
  const test::HeapTrap trap;
  for (std::int64_t k = 1; k < 1000; ++k) service.feed_watchdog({k * kQuarter_ns});
  EXPECT_EQ(trap.calls(), 0);
}

}  // namespace
}  // namespace articam
