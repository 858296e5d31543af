#pragma once
/// @file  Plain CDR of ROS 2 messages, little-endian, by Fast CDR 1 (Debian 12) or 2 (Ubuntu 24.04).

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace articam::listen {

/// Takes the fields of a message in the order of its definition. Plain numbers, strings, arrays and vectors of them.
class CdrWriter {
 public:
  CdrWriter() { cdr_.serialize_encapsulation(); }

  template <class T>
  CdrWriter& operator<<(const T& x) {
    cdr_ << x;
    return *this;
  }
  /// The message so far, its 4 bytes of encapsulation included. Valid until the next field.
  std::span<const std::uint8_t> bytes() { return {reinterpret_cast<std::uint8_t*>(buffer_.getBuffer()), length(cdr_)}; }

 private:
  /// Version 1 keeps its enumerators in the class, version 2 in the namespace: from inside a derived class both are
  /// found by one name.
  struct Cdr : eprosima::fastcdr::Cdr {
    static constexpr auto plain() {
      using namespace eprosima::fastcdr;
      return DDS_CDR;
    }
    explicit Cdr(eprosima::fastcdr::FastBuffer& buffer) : eprosima::fastcdr::Cdr(buffer, LITTLE_ENDIANNESS, plain()) {}
  };

  template <class C>
  static std::size_t length(const C& cdr) {
    if constexpr (requires { cdr.get_serialized_data_length(); }) {
      return cdr.get_serialized_data_length();
    } else {
      return cdr.getSerializedDataLength();
    }
  }

  eprosima::fastcdr::FastBuffer buffer_;
  Cdr cdr_{buffer_};
};

}  // namespace articam::listen
