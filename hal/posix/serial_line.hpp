#pragma once
/// @file  A serial line for packets, at either end.

#include "core/status.hpp"
#include "hal/wire/address.hpp"

namespace articam::hal {

/// Raw, 8 data bits, no parity, one stop bit, no flow control. `access`: O_RDONLY or O_RDWR. The descriptor, which
/// does not block; the caller closes it.
/// Errors  bad_argument when it is no serial address or a rate that the system does not name; no_device when the
/// device cannot be opened; io_error when it is no serial line. Of the last two errno says more.
Result<int> open_serial_line(const wire::Address& address, int access) noexcept;

}  // namespace articam::hal
