#include "hal/v4l2/video_calls.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>

namespace articam::hal::v4l2 {

int SystemVideoCalls::open(const char* path) noexcept {
  const int file = ::open(path, O_RDWR | O_NONBLOCK | O_CLOEXEC);
  return file >= 0 ? file : -errno;
}

void SystemVideoCalls::close(int file) noexcept { ::close(file); }

int SystemVideoCalls::control(int file, unsigned long request, void* argument) noexcept {
  int result = 0;
  do result = ::ioctl(file, request, argument);
  while (result < 0 && errno == EINTR);
  return result >= 0 ? result : -errno;
}

void* SystemVideoCalls::map(int file, std::size_t length, std::size_t offset) noexcept {
  void* const address = ::mmap(nullptr, length, PROT_READ, MAP_SHARED, file, static_cast<off_t>(offset));
  return address == MAP_FAILED ? nullptr : address;
}

void SystemVideoCalls::unmap(void* address, std::size_t length) noexcept { ::munmap(address, length); }

int SystemVideoCalls::wait(int file, std::chrono::milliseconds at_most) noexcept {
  pollfd watched{file, POLLIN, 0};
  const int result = ::poll(&watched, 1, static_cast<int>(at_most.count()));
  if (result < 0) return errno == EINTR ? 0 : -errno;  // the caller knows how much time is left
  return watched.revents;
}

}  // namespace articam::hal::v4l2
