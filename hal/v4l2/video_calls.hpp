#pragma once
/// @file  The system calls of a video device: the seam at which a test puts a scripted one.

#include <chrono>
#include <cstddef>

namespace articam::hal::v4l2 {

/// Results are those of the system calls, or an errno with its sign turned. Interrupted calls are taken up again.
class VideoCalls {
 public:
  virtual ~VideoCalls() = default;
  virtual int open(const char* path) noexcept = 0;  ///< read and write, not blocking
  virtual void close(int file) noexcept = 0;
  virtual int control(int file, unsigned long request, void* argument) noexcept = 0;  ///< ioctl
  virtual void* map(int file, std::size_t length, std::size_t offset) noexcept = 0;   ///< readable; nullptr: refused
  virtual void unmap(void* address, std::size_t length) noexcept = 0;
  virtual int wait(int file, std::chrono::milliseconds at_most) noexcept = 0;  ///< poll's events; 0: none in time
};

class SystemVideoCalls final : public VideoCalls {
 public:
  int open(const char* path) noexcept override;
  void close(int file) noexcept override;
  int control(int file, unsigned long request, void* argument) noexcept override;
  void* map(int file, std::size_t length, std::size_t offset) noexcept override;
  void unmap(void* address, std::size_t length) noexcept override;
  int wait(int file, std::chrono::milliseconds at_most) noexcept override;
};

}  // namespace articam::hal::v4l2
