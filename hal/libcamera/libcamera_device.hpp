#pragma once
/// @file  The real library behind the seam.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hal/libcamera/capture_device.hpp"

namespace libcamera {
class Camera;
class CameraConfiguration;
class CameraManager;
class FrameBuffer;
class FrameBufferAllocator;
class Request;
class Stream;
}  // namespace libcamera

namespace articam::hal {

/// One camera of libcamera. The library is started anew with each capture, so that a camera plugged in again is found
/// also where no udev daemon runs. libcamera allows one of these in a process at a time.
class LibcameraDevice final : public CaptureDevice {
 public:
  LibcameraDevice();
  ~LibcameraDevice() override;
  std::vector<std::string> cameras() override;
  Abilities open(const std::string& id) override;
  Stream configure(std::uint32_t format, int width_px, int height_px, int buffers) override;
  void start(const Controls& controls, CaptureEvents& events) override;
  void begin_reading(int buffer) noexcept override;
  void end_reading(int buffer) noexcept override;
  bool queue(int buffer) noexcept override;
  void close() noexcept override;

 private:
  struct Mapping {
    void* address{};
    std::size_t length{};
    int memory{};  ///< the DMA buffer's descriptor, owned by the library
  };

  std::span<const std::uint8_t> map_first_plane(const libcamera::FrameBuffer& buffer);
  void make_requests();
  void on_completed(libcamera::Request* request);
  void on_disconnected();

  std::unique_ptr<libcamera::CameraManager> library_;
  std::shared_ptr<libcamera::Camera> camera_;
  bool acquired_{false};
  std::unique_ptr<libcamera::CameraConfiguration> configuration_;
  libcamera::Stream* stream_{};
  std::unique_ptr<libcamera::FrameBufferAllocator> allocator_;
  std::vector<std::unique_ptr<libcamera::Request>> requests_;  ///< one a buffer, numbered by its cookie
  std::vector<Mapping> mappings_;                              ///< one a buffer
  CaptureEvents* events_{};
};

}  // namespace articam::hal
