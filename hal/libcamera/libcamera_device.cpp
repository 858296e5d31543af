#include "hal/libcamera/libcamera_device.hpp"

#include <libcamera/libcamera.h>
#include <linux/dma-buf.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "hal/capture/start_problem.hpp"
#include "hal/libcamera/libcamera_camera.hpp"
#include "hal/libcamera/library_version.hpp"

namespace articam::hal {
namespace {

/// The library answers 0, or an errno with its sign turned.
void check(int result, const std::string& what) {
  if (result >= 0) return;
  const Status status = result == -ENODEV ? Status::no_device : Status::io_error;
  std::string reason = "libcamera could not " + what + ": " + std::strerror(-result);
  if (result == -EBUSY) reason += " (does another program use the camera?)";
  throw StartProblem{status, std::move(reason)};
}

/// Where the memory is cached and the camera writes behind the cache's back, old lines are dropped here. Memory that is
/// not of that kind refuses the call, and needs none.
void sync_cache(int memory, std::uint64_t edge) noexcept {
  dma_buf_sync sync{DMA_BUF_SYNC_READ | edge};
  int result = 0;
  do result = ::ioctl(memory, DMA_BUF_IOCTL_SYNC, &sync);
  while (result < 0 && (errno == EINTR || errno == EAGAIN));
}

std::optional<double> number(const libcamera::ControlValue& value) {
  if (value.isArray()) return std::nullopt;
  switch (value.type()) {
    case libcamera::ControlTypeInteger32:
      return value.get<std::int32_t>();
    case libcamera::ControlTypeInteger64:
      return static_cast<double>(value.get<std::int64_t>());
    case libcamera::ControlTypeFloat:
      return static_cast<double>(value.get<float>());
    default:
      return std::nullopt;
  }
}

std::optional<ControlRange> range_of(const libcamera::Camera& camera, const libcamera::ControlId& control) {
  const auto found = camera.controls().find(control.id());
  if (found == camera.controls().end()) return std::nullopt;
  const auto min = number(found->second.min()), max = number(found->second.max());
  if (!min || !max) return std::nullopt;
  return ControlRange{*min, *max};
}

}  // namespace

LibcameraDevice::LibcameraDevice() = default;
LibcameraDevice::~LibcameraDevice() { close(); }

std::vector<std::string> LibcameraDevice::cameras() {
  library_ = std::make_unique<libcamera::CameraManager>();
  check(library_->start(), "look for cameras");
  std::vector<std::string> ids;
  for (const auto& camera : library_->cameras()) ids.push_back(camera->id());
  return ids;
}

Abilities LibcameraDevice::open(const std::string& id) {
  camera_ = library_->get(id);
  if (!camera_) throw StartProblem{Status::no_device, "camera " + id + " was unplugged as it was opened"};
  check(camera_->acquire(), "take camera " + id);
  acquired_ = true;
  configuration_ = camera_->generateConfiguration({libcamera::StreamRole::Viewfinder});
  if (!configuration_ || configuration_->empty()) {
    throw StartProblem{Status::bad_argument, "camera " + id + " offers no video stream"};
  }
  Abilities abilities;
  for (const auto& format : configuration_->at(0).formats().pixelformats()) {
    if (format.modifier() == 0) abilities.formats.push_back(format.fourcc());  // others are tiled or compressed
  }
  abilities.exposure_us = range_of(*camera_, libcamera::controls::ExposureTime);
  abilities.gain = range_of(*camera_, libcamera::controls::AnalogueGain);
  abilities.period_us = range_of(*camera_, libcamera::controls::FrameDurationLimits);
  return abilities;
}

Stream LibcameraDevice::configure(std::uint32_t format, int width_px, int height_px, int buffers) {
  libcamera::StreamConfiguration& wanted = configuration_->at(0);
  wanted.pixelFormat = libcamera::PixelFormat{format};
  wanted.size = {static_cast<unsigned>(width_px), static_cast<unsigned>(height_px)};
  wanted.stride = 0;  // the library's choice for this size, not for its default one
  wanted.bufferCount = static_cast<unsigned>(buffers);
  if (configuration_->validate() == libcamera::CameraConfiguration::Invalid) {
    throw StartProblem{Status::bad_argument, "libcamera refuses the stream " + wanted.toString()};
  }
  check(camera_->configure(configuration_.get()), "configure the stream " + wanted.toString());
  stream_ = wanted.stream();
  allocator_ = std::make_unique<libcamera::FrameBufferAllocator>(camera_);
  check(allocator_->allocate(stream_), "allocate its buffers");

  Stream stream{wanted.pixelFormat.fourcc(),
                static_cast<int>(wanted.size.width),
                static_cast<int>(wanted.size.height),
                wanted.stride,
                {}};
  for (const auto& buffer : allocator_->buffers(stream_)) stream.buffers.push_back(map_first_plane(*buffer));
  return stream;
}

std::span<const std::uint8_t> LibcameraDevice::map_first_plane(const libcamera::FrameBuffer& buffer) {
  const auto& planes = buffer.planes();
  if (planes.empty()) throw StartProblem{Status::io_error, "libcamera gave a buffer without memory"};
  const auto& plane = planes[0];
  const std::size_t length = std::size_t{plane.offset} + plane.length;  // a mapping begins on a page, so at 0
  void* const address = ::mmap(nullptr, length, PROT_READ, MAP_SHARED, plane.fd.get(), 0);
  if (address == MAP_FAILED) check(-errno, "map its buffers");
  mappings_.push_back({address, length, plane.fd.get()});
  return {static_cast<const std::uint8_t*>(address) + plane.offset, plane.length};
}

void LibcameraDevice::start(const Controls& controls, CaptureEvents& events) {
  events_ = &events;
  make_requests();
  camera_->requestCompleted.connect(this, &LibcameraDevice::on_completed);
  camera_->disconnected.connect(this, &LibcameraDevice::on_disconnected);
  const libcamera::ControlList list = control_list(camera_->controls(), controls);
  check(camera_->start(&list), "start the capture");
  for (const auto& request : requests_) {
    request->controls().merge(list);  // several pipelines of the library heed no list given to start
    check(camera_->queueRequest(request.get()), "queue a buffer");
  }
}

void LibcameraDevice::make_requests() {
  for (const auto& buffer : allocator_->buffers(stream_)) {
    auto request = camera_->createRequest(requests_.size());
    if (!request) check(-ENOMEM, "make a request");
    check(request->addBuffer(stream_, buffer.get()), "give a request its buffer");
    requests_.push_back(std::move(request));
  }
}

void LibcameraDevice::on_completed(libcamera::Request* request) {
  const libcamera::FrameMetadata& frame = request->buffers().begin()->second->metadata();
  const auto& metadata = request->metadata();
  CompletedBuffer buffer{.buffer = static_cast<int>(request->cookie()), .health = health_of(frame)};
  if (request->status() == libcamera::Request::RequestCancelled) buffer.health = CompletedBuffer::Health::cancelled;
  buffer.sequence = frame.sequence;
  const auto sensor_stamp = metadata.get(libcamera::controls::SensorTimestamp);
  buffer.stamp.ns = sensor_stamp.value_or(static_cast<std::int64_t>(frame.timestamp));
  buffer.exposure_ns = std::int64_t{metadata.get(libcamera::controls::ExposureTime).value_or(0)} * 1000;
  buffer.bytes_used = frame.planes().empty() ? 0 : frame.planes()[0].bytesused;
  events_->completed(buffer);
}

void LibcameraDevice::on_disconnected() { events_->disconnected(); }

void LibcameraDevice::begin_reading(int buffer) noexcept {
  sync_cache(mappings_[static_cast<std::size_t>(buffer)].memory, DMA_BUF_SYNC_START);
}

void LibcameraDevice::end_reading(int buffer) noexcept {
  sync_cache(mappings_[static_cast<std::size_t>(buffer)].memory, DMA_BUF_SYNC_END);
}

bool LibcameraDevice::queue(int buffer) noexcept {
  try {
    libcamera::Request& request = *requests_[static_cast<std::size_t>(buffer)];
    request.reuse(libcamera::Request::ReuseBuffers);
    return camera_->queueRequest(&request) == 0;
  } catch (...) {  // only memory can be short here; the buffer is lost
    return false;
  }
}

void LibcameraDevice::close() noexcept {
  try {
    if (camera_) {
      camera_->stop();
      camera_->requestCompleted.disconnect(this);
      camera_->disconnected.disconnect(this);
    }
    requests_.clear();
    for (const Mapping& mapping : std::exchange(mappings_, {})) ::munmap(mapping.address, mapping.length);
    allocator_.reset();
    configuration_.reset();
    if (std::exchange(acquired_, false)) camera_->release();
    camera_.reset();
    library_.reset();  // joins its thread: from here on no event can come
  } catch (...) {      // nothing of this is said to throw; a capture that is being given up has no one to tell
  }
}

LibcameraCamera::LibcameraCamera(LibcameraOptions options)
    : LibcameraCamera{std::move(options), std::make_unique<LibcameraDevice>()} {}

}  // namespace articam::hal
