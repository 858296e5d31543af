#include "hal/authentication/keyed_signer.hpp"

namespace articam::hal {

Status KeyedSigner::open() {
  next_ = end_ = 0;
  const Status status = file_.add(block_, next_);
  if (status == Status::ok) end_ = next_ + block_;
  return status;
}

Result<std::uint64_t> KeyedSigner::next_counter() noexcept {
  if (next_ == end_) return Status::io_error;
  return next_++;
}

}  // namespace articam::hal
