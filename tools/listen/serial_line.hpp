#pragma once
/// @file  A serial line for reading.

#include <cstdint>

namespace articam::listen {

/// Raw, 8 data bits, no parity, one stop bit, no flow control, as the board's link writes it. The descriptor, that does
/// not block; or -1 and errno (EINVAL for a rate that the system has no name for).
int open_serial_line(const char* device, std::uint32_t baud);

}  // namespace articam::listen
