#include "hal/authentication/keyed_verifier.hpp"

#include <limits>
#include <utility>

namespace articam::hal {

Status KeyedVerifier::open(const std::string& state_path) {
  CounterFile file{state_path};
  std::uint64_t least = 0;
  Status status = file.read(least);
  if (status == Status::ok) status = file.write(least);  // that it can be written is better known now
  if (status != Status::ok) {
    problem_ = file.problem();
    return status;
  }
  least_ = saved_ = least;
  file_ = std::move(file);
  return Status::ok;
}

wire::Fault KeyedVerifier::admit(std::span<const std::uint8_t> covered, std::uint64_t counter,
                                 wire::ConstTag tag) noexcept {
  if (!key_.matches(covered, tag)) return wire::Fault::not_authentic;
  if (counter < least_ || counter == std::numeric_limits<std::uint64_t>::max()) return wire::Fault::replayed;
  least_ = counter + 1;
  if (least_ - saved_ >= kStride) save();
  return wire::Fault::none;
}

void KeyedVerifier::save() noexcept {
  if (!file_ || saved_ == least_) return;
  // Where the disk fails, packets are still judged by what is in memory; the next stride tries again.
  static_cast<void>(file_->write(least_));
  saved_ = least_;
}

}  // namespace articam::hal
