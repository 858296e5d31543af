#include "hal/wire/message_reader.hpp"

#include <bit>
#include <limits>

#include "hal/wire/byte_order.hpp"
#include "hal/wire/utf8.hpp"

namespace articam::wire {
namespace {

using Bytes = std::span<const std::uint8_t>;

enum class WireType : std::uint8_t { varint = 0, fixed64 = 1, bytes = 2, fixed32 = 5 };

struct Field {
  std::uint64_t number{};
  WireType type{};
  std::uint64_t value{};  ///< of a varint or a fixed number
  Bytes bytes{};          ///< of a string, a message or a packed list
};

bool take_varint(Bytes& rest, std::uint64_t& x) noexcept {
  x = 0;
  for (int shift = 0; shift < 64 && !rest.empty(); shift += 7) {
    const std::uint64_t byte = rest.front();
    rest = rest.subspan(1);
    if (shift == 63 && byte > 1) return false;  // more than 64 bits
    x |= (byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return true;
  }
  return false;
}

/// The tag of a field, or the size of what follows: 32 bits in five bytes at most, as protobuf has it.
bool take_short_varint(Bytes& rest, std::uint64_t& x) noexcept {
  const std::size_t before = rest.size();
  return take_varint(rest, x) && before - rest.size() <= 5 && x <= std::numeric_limits<std::uint32_t>::max();
}

bool take_bytes(Bytes& rest, std::uint64_t size, Bytes& out) noexcept {
  if (size > rest.size()) return false;
  out = rest.first(static_cast<std::size_t>(size));
  rest = rest.subspan(static_cast<std::size_t>(size));
  return true;
}

bool take_field(Bytes& rest, Field& field) noexcept {
  std::uint64_t tag = 0;
  if (!take_short_varint(rest, tag)) return false;
  field = {.number = tag >> 3, .type = static_cast<WireType>(tag & 7)};
  if (field.number == 0) return false;
  std::uint64_t size = 0;
  switch (field.type) {
    case WireType::varint:
      return take_varint(rest, field.value);
    case WireType::bytes:
      return take_short_varint(rest, size) && take_bytes(rest, size, field.bytes);
    case WireType::fixed64:
      if (!take_bytes(rest, 8, field.bytes)) return false;
      field.value = load<std::uint64_t>(field.bytes.first<8>());
      return true;
    case WireType::fixed32:
      return take_bytes(rest, 4, field.bytes);
  }
  return false;  // a group, or no wire type at all
}

bool read(const Field& field, std::uint32_t& x) noexcept {
  x = static_cast<std::uint32_t>(field.value);
  return field.type == WireType::varint && x == field.value;
}
bool read(const Field& field, bool& x) noexcept {
  x = field.value != 0;
  return field.type == WireType::varint && field.value <= 1;
}
bool read(const Field& field, std::uint64_t& x) noexcept {
  x = field.value;
  return field.type == WireType::fixed64;
}
bool read(const Field& field, Timestamp& t) noexcept {
  t.ns = static_cast<std::int64_t>(field.value);
  return field.type == WireType::fixed64;
}
bool read(const Field& field, double& x) noexcept {
  x = std::bit_cast<double>(field.value);
  return field.type == WireType::fixed64;
}
/// An enumerator that this build does not know has no name and no meaning here: refused.
template <class Enum>
bool read_enum(const Field& field, Enum last, Enum& x) noexcept {
  if (field.type != WireType::varint || field.value > static_cast<std::uint64_t>(last)) return false;
  x = static_cast<Enum>(field.value);
  return true;
}
bool read(const Field& field, Text& text) noexcept {
  text.clear();
  for (const std::uint8_t byte : field.bytes) {
    if (!text.push_back(static_cast<char>(byte))) return false;
  }
  return field.type == WireType::bytes && is_utf8(field.bytes);
}

// Lists may come packed or one by one, and in several pieces.
template <std::size_t N>
bool append(const Field& field, FixedVector<double, N>& list) noexcept {
  if (field.type == WireType::fixed64) return list.push_back(std::bit_cast<double>(field.value));
  if (field.type != WireType::bytes || field.bytes.size() % 8 != 0) return false;
  for (Bytes rest = field.bytes; !rest.empty(); rest = rest.subspan(8)) {
    if (!list.push_back(std::bit_cast<double>(load<std::uint64_t>(rest.first<8>())))) return false;
  }
  return true;
}
template <class Enum, std::size_t N>
bool append_enums(const Field& field, Enum last, FixedVector<Enum, N>& list) noexcept {
  Enum x{};
  if (field.type == WireType::varint) return read_enum(field, last, x) && list.push_back(x);
  Field item{.number = field.number, .type = WireType::varint};
  for (Bytes rest = field.bytes; !rest.empty();) {
    if (!take_varint(rest, item.value) || !read_enum(item, last, x) || !list.push_back(x)) return false;
  }
  return field.type == WireType::bytes;
}
bool append(const Field& field, FixedVector<Text, kMaxJoints>& list) noexcept {
  Text text;
  return read(field, text) && list.push_back(text);
}

/// False when the field is known and wrong.
bool read_field(const Field& field, EstimateMessage& out) noexcept {
  // clang-format off
  switch (field.number) {
    case 1:  return read(field, out.schema);
    case 2:  return read(field, out.session);
    case 3:  return read(field, out.model_hash);
    case 4:  return read(field, out.number);
    case 5:  return read(field, out.frame);
    case 6:  return read(field, out.t_capture);
    case 7:  return read(field, out.t_send);
    case 8:  return read_enum(field, tracker::TrackingStatus::fault, out.status);
    case 9:  return read_enum(field, tracker::Reason::blurred, out.reason);
    case 10: return read(field, out.valid);
    case 11: return append(field, out.t_cam_obj);
    case 12: return append(field, out.joints);
    case 13: return append(field, out.velocity);
    case 14: return append(field, out.covariance);
    case 15: return append_enums(field, tracker::Observability::observed, out.observability);
    case 16: return read(field, out.matched);
    case 17: return read(field, out.rms_px);
    case 18: return append(field, out.t_base_obj);
    default: return true;
  }
  // clang-format on
}

bool read_field(const Field& field, ModelMessage& out) noexcept {
  // clang-format off
  switch (field.number) {
    case 1:  return read(field, out.schema);
    case 2:  return read(field, out.session);
    case 3:  return read(field, out.model_hash);
    case 4:  return read(field, out.name);
    case 5:  return append(field, out.joint_names);
    case 6:  return read(field, out.rate_hz);
    case 7:  return append(field, out.t_base_cam);
    case 8:  return append_enums(field, model::JointKind::prismatic, out.joint_kinds);
    default: return true;
  }
  // clang-format on
}

template <class Content>
Fault parse(Bytes rest, Content& out) noexcept {
  out = {};
  out.schema = 0;  // absent is not ours
  Field field;
  while (!rest.empty()) {
    if (!take_field(rest, field) || !read_field(field, out)) return Fault::malformed;
    if (field.number == 1 && out.schema != kSchema) return Fault::unknown_schema;  // before its fields mislead
  }
  return out.schema == kSchema ? Fault::none : Fault::unknown_schema;
}

}  // namespace

Fault parse_message(std::span<const std::uint8_t> payload, Message& out) noexcept {
  out.kind = MessageKind::none;
  Field field;
  while (!payload.empty()) {
    if (!take_field(payload, field)) return Fault::malformed;
    if (field.number > 2) continue;
    if (field.type != WireType::bytes || out.kind != MessageKind::none) return Fault::malformed;
    out.kind = field.number == 1 ? MessageKind::estimate : MessageKind::model;
    const Fault fault = field.number == 1 ? parse(field.bytes, out.estimate) : parse(field.bytes, out.model);
    if (fault != Fault::none) return fault;
  }
  return out.kind == MessageKind::none ? Fault::malformed : Fault::none;
}

Fault read_message(std::span<const std::uint8_t> payload, Message& out) noexcept {
  const Fault fault = parse_message(payload, out);
  if (fault != Fault::none) return fault;
  return out.kind == MessageKind::estimate ? check(out.estimate) : check(out.model);
}

}  // namespace articam::wire
