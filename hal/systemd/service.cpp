#include "hal/systemd/service.hpp"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace articam::hal {
namespace {

std::string_view variable(const char* name) noexcept {
  const char* const value = std::getenv(name);
  return value != nullptr ? std::string_view{value} : std::string_view{};
}

/// 0 where there is none, or it is no number.
std::uint64_t number_of(const char* name) noexcept {
  const std::string_view text = variable(name);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? number : 0;
}

/// Of this process, not of one that handed its variables down.
std::chrono::microseconds watchdog_limit() noexcept {
  const bool ours = variable("WATCHDOG_PID").empty() || number_of("WATCHDOG_PID") == std::uint64_t(::getpid());
  return std::chrono::microseconds{ours ? number_of("WATCHDOG_USEC") : 0};
}

}  // namespace

Service::Service() noexcept {
  const std::string_view path = variable("NOTIFY_SOCKET");
  const bool of_this_machine = path.starts_with('/') || path.starts_with('@');
  if (!of_this_machine || path.size() >= sizeof manager_.sun_path) return;
  manager_.sun_family = AF_UNIX;
  std::memcpy(manager_.sun_path, path.data(), path.size());
  if (path.starts_with('@')) manager_.sun_path[0] = '\0';  // an address without a file
  manager_size_ = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
  socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  interval_ = watchdog_limit() / 4;
}

Service::~Service() {
  if (socket_ >= 0) ::close(socket_);
}

void Service::tell_ready() noexcept { (void)tell("READY=1", 0); }
void Service::tell_stopping() noexcept { (void)tell("STOPPING=1", MSG_DONTWAIT); }

void Service::feed_watchdog(Timestamp now) noexcept {
  if (interval_.count() == 0 || now < next_) return;
  if (tell("WATCHDOG=1", MSG_DONTWAIT)) next_ = {now.ns + interval_.count()};
}

bool Service::tell(std::string_view words, int flags) noexcept {
  if (socket_ < 0) return false;
  ssize_t sent = 0;
  // Addressed each time, not connected: the manager may have bound its socket anew.
  do
    sent = ::sendto(socket_, words.data(), words.size(), flags | MSG_NOSIGNAL,
                    reinterpret_cast<const sockaddr*>(&manager_), manager_size_);
  while (sent < 0 && errno == EINTR);
  return sent == static_cast<ssize_t>(words.size());
}

}  // namespace articam::hal
