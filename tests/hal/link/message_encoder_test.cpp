#include "hal/link/message_encoder.hpp"

#include <gtest/gtest.h>

#include "tests/support/wire_messages.hpp"

namespace articam {
namespace {

template <class M>
std::string by_nanopb(const M& message) {
  std::array<std::uint8_t, wire::kMaxPayloadSize> buffer;
  const auto size = hal::encode_message(message, buffer);
  EXPECT_TRUE(size.ok());
  return {reinterpret_cast<const char*>(buffer.data()), size.ok() ? size.value() : 0};
}

TEST(MessageEncoder, WritesTheVeryBytesThatProtobufWrites) {
  test::Random random{11};
  for (std::size_t trial = 0; trial < 1000; ++trial) {
    const std::size_t num_joints = trial % (wire::kMaxJoints + 1);
    const auto estimate = test::random_estimate(random, num_joints);
    const auto model = test::random_model(random, num_joints);
    ASSERT_EQ(by_nanopb(estimate), test::by_protobuf(estimate)) << "seed 11, trial " << trial;
    ASSERT_EQ(by_nanopb(model), test::by_protobuf(model)) << "seed 11, trial " << trial;
  }
}

TEST(MessageEncoder, WritesTheLargestMessagesIntoOnePacket) {
  wire::EstimateMessage m;
  const auto fill = [](auto& list, auto x) {
    while (list.push_back(x)) continue;
  };
  m.session = m.model_hash = ~std::uint64_t{0}, m.number = m.frame = m.matched = ~std::uint32_t{0};
  m.t_capture.ns = m.t_send.ns = -1, m.rms_px = 1e300, m.valid = true;
  m.status = tracker::TrackingStatus::fault, m.reason = tracker::Reason::blurred;
  fill(m.t_cam_obj, 1.0), fill(m.joints, 1.0), fill(m.velocity, 1.0), fill(m.covariance, 1.0);
  fill(m.observability, tracker::Observability::observed), fill(m.t_base_obj, 1.0);
  EXPECT_EQ(by_nanopb(m), test::by_protobuf(m));
  EXPECT_LE(by_nanopb(m).size(), wire::kMaxPayloadSize);
}

TEST(MessageEncoder, AMessageOfNineJointsFitsIntoOneEthernetFrameWithItsTag) {
  test::Random random{13};
  auto m = test::random_estimate(random, 9);
  m.number = m.frame = m.matched = ~std::uint32_t{0};  // as long as varints get
  test::fill_pose(m.t_base_obj, random);
  constexpr std::size_t kEthernet = 1500 - 20 - 8;  // less the headers of IP and UDP
  EXPECT_LE(wire::kHeaderSize + by_nanopb(m).size() + wire::kTrailerSize + wire::kChecksumSize, kEthernet);
}

TEST(MessageEncoder, RefusesABufferThatIsTooSmall) {
  test::Random random{12};
  const auto m = test::random_estimate(random);
  std::vector<std::uint8_t> buffer(test::by_protobuf(m).size());
  EXPECT_TRUE(hal::encode_message(m, buffer).ok());
  buffer.pop_back();
  EXPECT_EQ(hal::encode_message(m, buffer).status(), Status::bad_argument);
}

}  // namespace
}  // namespace articam
