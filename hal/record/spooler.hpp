#pragma once
/// @file  From the loop to a file without waiting for it.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "core/status.hpp"
#include "hal/posix/semaphore.hpp"

namespace articam::hal {

/// Blocks of bounded size go through a fixed ring to a thread that writes them into a file whose space is already
/// there. reserve() and commit() are for one thread; they never wait and never allocate.
class Spooler {
 public:
  Spooler() noexcept = default;
  Spooler(const Spooler&) = delete;
  Spooler& operator=(const Spooler&) = delete;
  ~Spooler() { (void)close(); }  // whoever wants to know has called close()

  struct Options {
    std::string path;
    std::uint64_t file_bytes{};
    std::size_t block_bytes{}, num_blocks{};
  };
  /// A file of that name is renamed to `<path>.before`.
  /// Errors  io_error; problem() is a sentence with path and cause.
  Status open(const Options& options) noexcept;
  bool is_open() const noexcept { return descriptor_ >= 0; }

  /// Where the next block is to be built; empty when the writer is behind.
  std::span<std::byte> reserve() noexcept;
  /// Hands the reserved block over: its first `bytes` are to be at `offset` of the file. The writer puts the CRC-32 of
  /// all behind it at `crc_at` of the block: a whole image takes milliseconds that the loop does not have.
  void commit(std::size_t bytes, std::uint64_t offset, std::size_t crc_at) noexcept;

  /// Writes what is left and makes it last. `end`: the file is cut there; 0 keeps its size.
  Status close(std::uint64_t end = 0) noexcept;
  const std::string& problem() const noexcept { return problem_; }

 private:
  struct Block {
    std::size_t bytes{};
    std::uint64_t offset{};
    std::size_t crc_at{};
  };

  void write_blocks() noexcept;
  bool write(const std::byte* data, std::size_t bytes, std::uint64_t offset) noexcept;
  Status fail(const char* what, int error) noexcept;

  int descriptor_{-1};
  std::string path_, problem_;
  std::size_t block_bytes_{};
  std::vector<std::byte> storage_;
  std::vector<Block> blocks_;
  std::size_t head_{};               ///< next block to build; the loop's
  std::atomic<std::size_t> free_{};  ///< blocks that the loop may take
  Semaphore ready_;
  std::atomic<bool> ends_{false};
  std::atomic<int> error_{0};  ///< errno of the first write that failed
  std::thread writer_;
};

}  // namespace articam::hal
