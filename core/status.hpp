#pragma once
/// @file  Why a call could not do its work, and a value or the reason there is none.

#include <cstdint>
#include <string_view>
#include <type_traits>

namespace articam {

enum class [[nodiscard]] Status : std::uint8_t{
    ok,
    timeout,           ///< nothing arrived in time; try again
    end_of_stream,     ///< a recording has no more frames
    io_error,          ///< a file or device could not be read or written
    no_device,         ///< the device is not there, or was unplugged
    bad_argument,      ///< an input is not finite, out of range or of the wrong size
    behind_camera,     ///< depth is not positive, or not a number
    outside_domain,    ///< the inverse of the lens distortion does not converge here
    too_few_features,  ///< fewer features than the computation needs
    ill_conditioned,   ///< the normal matrix could not be factorised
};

/// The name of a status, as written in logs.
constexpr std::string_view name(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::timeout:
      return "timeout";
    case Status::end_of_stream:
      return "end_of_stream";
    case Status::io_error:
      return "io_error";
    case Status::no_device:
      return "no_device";
    case Status::bad_argument:
      return "bad_argument";
    case Status::behind_camera:
      return "behind_camera";
    case Status::outside_domain:
      return "outside_domain";
    case Status::too_few_features:
      return "too_few_features";
    case Status::ill_conditioned:
      return "ill_conditioned";
  }
  return "unknown";
}

/// A value, or the reason there is none. Lives on the stack; never throws.
template <class T>
class [[nodiscard]] Result {
  static_assert(std::is_trivially_destructible_v<T>, "plain values only");

 public:
  constexpr Result(const T& value) noexcept : value_{value} {}
  constexpr Result(Status why) noexcept : status_{why} {}  ///< why is not ok
  constexpr bool ok() const noexcept { return status_ == Status::ok; }
  constexpr Status status() const noexcept { return status_; }
  constexpr const T& value() const noexcept { return value_; }  ///< only if ok()

 private:
  T value_{};
  Status status_{Status::ok};
};

}  // namespace articam
