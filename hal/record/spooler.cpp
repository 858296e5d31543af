#include "hal/record/spooler.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

#include "hal/wire/crc32.hpp"

namespace articam::hal {
namespace {

void seal(std::span<std::byte> block, std::size_t crc_at) noexcept {
  const std::span<const std::byte> covered = block.subspan(crc_at + sizeof(std::uint32_t));
  const std::uint32_t crc = wire::crc32({reinterpret_cast<const std::uint8_t*>(covered.data()), covered.size()});
  std::memcpy(block.data() + crc_at, &crc, sizeof crc);
}

}  // namespace

Status Spooler::open(const Options& options) noexcept {
  (void)close();
  try {
    path_ = options.path;
    problem_.clear();
    block_bytes_ = options.block_bytes;
    storage_.assign(options.block_bytes * options.num_blocks, std::byte{});
    blocks_.assign(options.num_blocks, Block{});
    head_ = 0;
    free_ = options.num_blocks;
    ends_ = false;
    error_ = 0;
    // What is there may be the recording of what went wrong before a restart.
    (void)std::rename(path_.c_str(), (path_ + ".before").c_str());
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor_ < 0) return fail("cannot be written", errno);
    const int error = ::posix_fallocate(descriptor_, 0, static_cast<off_t>(options.file_bytes));
    if (error != 0) return fail("there is no room for the recording", error);
    writer_ = std::thread{[this] { write_blocks(); }};
    return Status::ok;
  } catch (const std::exception& e) {
    problem_ = e.what();
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
    return Status::io_error;
  }
}

std::span<std::byte> Spooler::reserve() noexcept {
  if (!is_open() || free_.load(std::memory_order_acquire) == 0) return {};
  return {storage_.data() + head_ * block_bytes_, block_bytes_};
}

void Spooler::commit(std::size_t bytes, std::uint64_t offset, std::size_t crc_at) noexcept {
  blocks_[head_] = {bytes, offset, crc_at};
  head_ = (head_ + 1) % blocks_.size();
  free_.fetch_sub(1, std::memory_order_relaxed);
  ready_.post();
}

void Spooler::write_blocks() noexcept {
  for (std::size_t tail = 0;; tail = (tail + 1) % blocks_.size()) {
    ready_.wait();
    // close() releases once more than there are blocks.
    if (ends_ && free_.load(std::memory_order_acquire) == blocks_.size()) return;
    const auto [bytes, offset, crc_at] = blocks_[tail];
    const std::span<std::byte> block{storage_.data() + tail * block_bytes_, bytes};
    seal(block, crc_at);
    if (error_ == 0 && !write(block.data(), bytes, offset)) error_ = errno;
    free_.fetch_add(1, std::memory_order_release);
  }
}

bool Spooler::write(const std::byte* data, std::size_t bytes, std::uint64_t offset) noexcept {
  while (bytes > 0) {
    const ssize_t n = ::pwrite(descriptor_, data, bytes, static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    data += n, bytes -= static_cast<std::size_t>(n), offset += static_cast<std::uint64_t>(n);
  }
  return true;
}

Status Spooler::close(std::uint64_t end) noexcept {
  if (writer_.joinable()) {
    ends_ = true;
    ready_.post();
    writer_.join();
  }
  if (descriptor_ < 0) return Status::ok;
  int error = error_;
  if (error == 0 && end > 0 && ::ftruncate(descriptor_, static_cast<off_t>(end)) != 0) error = errno;
  if (error == 0 && ::fsync(descriptor_) != 0) error = errno;
  if (::close(descriptor_) != 0 && error == 0) error = errno;
  descriptor_ = -1;
  return error == 0 ? Status::ok : fail("could not be written to its end", error);
}

Status Spooler::fail(const char* what, int error) noexcept {
  try {
    problem_ = path_ + ": " + what + ": " + std::strerror(error);
  } catch (const std::exception&) {
  }
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  return Status::io_error;
}

}  // namespace articam::hal
