#include "hal/baremetal/semihosting_camera.hpp"

#include "hal/baremetal/line.hpp"
#include "hal/baremetal/semihosting.hpp"

namespace articam::hal {
namespace {

/// The next number of a PGM header, at most 9999; -1 where there is none. Takes the one white space behind it.
int read_number(semihosting::File& file) noexcept {
  int number = -1;
  for (std::uint8_t c = 0; file.read({&c, 1}) == 1 && c >= '0' && c <= '9';) {
    number = (number < 0 ? 0 : number) * 10 + (c - '0');
    if (number > 9999) return -1;
  }
  return number;
}

}  // namespace

Status SemihostingCamera::acquire(Frame& out, std::chrono::milliseconds) noexcept {
  Line path;
  path << folder_ << "/frame_" << decimal(next_, 6) << ".pgm";
  ImageView image;
  if (const Status status = read(path.text(), image); status != Status::ok) return status;
  now_ = from_seconds(next_ / rate_hz_);
  out = {image, now_, next_++};
  return Status::ok;
}

Status SemihostingCamera::read(std::string_view path, ImageView& out) noexcept {
  semihosting::File file{path};
  if (!file.is_open()) return Status::end_of_stream;
  std::array<std::uint8_t, 3> magic{};
  const bool is_pgm = file.read(magic) == magic.size() && magic[0] == 'P' && magic[1] == '5';
  const int width = read_number(file), height = read_number(file), maximum = read_number(file);
  const ImageView image{pixels_.data(), width, height, width};
  if (!is_pgm || maximum != 255 || !image.ok()) return ++next_, Status::io_error;
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (file.read({pixels_.data(), size}) != size) return ++next_, Status::io_error;
  out = image;
  return Status::ok;
}

}  // namespace articam::hal
