#include "hal/replay/pgm_camera.hpp"

#include <glob.h>

#include <algorithm>
#include <exception>

namespace articam::hal {

std::vector<std::filesystem::path> find_frames(const std::string& what) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  if (std::filesystem::is_directory(what, error)) {
    // Not a range-for: its ++ throws where the folder cannot be read to its end.
    for (std::filesystem::directory_iterator entry{what, error}, end; !error && entry != end; entry.increment(error)) {
      if (entry->path().extension() == ".pgm") files.push_back(entry->path());
    }
  } else {
    glob_t found{};
    if (::glob(what.c_str(), 0, nullptr, &found) == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    ::globfree(&found);
  }
  std::sort(files.begin(), files.end());
  return files;
}

PgmCamera::PgmCamera(std::vector<std::filesystem::path> files, double rate_hz)
    : files_{std::move(files)}, rate_hz_{rate_hz} {}

Timestamp PgmCamera::t_exposure(std::size_t frame) const noexcept {
  return from_seconds(static_cast<double>(frame) / rate_hz_);
}

Status PgmCamera::acquire(Frame& out, std::chrono::milliseconds) noexcept {
  if (next_ >= files_.size()) return Status::end_of_stream;
  const std::size_t frame = next_++;
  try {
    if (const Status status = read_pgm(files_[frame], image_, problem_); status != Status::ok) return status;
  } catch (const std::exception& e) {
    problem_ = e.what();
    return Status::io_error;
  }
  out = {image_.view(), t_exposure(frame), static_cast<std::uint32_t>(frame)};
  return Status::ok;
}

}  // namespace articam::hal
