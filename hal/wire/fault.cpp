#include "hal/wire/fault.hpp"

#include <array>
#include <cstddef>

namespace articam::wire {

std::string_view name(Fault fault) noexcept {
  constexpr std::string_view kNames[]{"none",           "foreign",       "wrong_length", "wrong_checksum",
                                      "unknown_format", "not_authentic", "replayed",     "malformed",
                                      "unknown_schema", "inconsistent",  "wrong_model"};
  static_assert(std::size(kNames) == kNumFaults);
  return kNames[static_cast<std::size_t>(fault)];
}

}  // namespace articam::wire
