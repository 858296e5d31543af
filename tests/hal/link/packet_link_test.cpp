#include "hal/link/packet_link.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "hal/link/session.hpp"
#include "hal/memory/manual_clock.hpp"
#include "hal/wire/message_reader.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "tests/support/heap_trap.hpp"
#include "tests/support/random_state.hpp"

namespace articam {
namespace {

using M = models::PrinterDrawer;

/// Keeps the messages of the packets that it is given, and can refuse them.
class Ear {
 public:
  Status send(std::span<const std::uint8_t> packet) noexcept {
    if (deaf) return Status::io_error;
    wire::PacketView view;
    wire::Message message;
    size = packet.size();
    EXPECT_EQ(wire::open_packet(packet, view), wire::Fault::none);
    EXPECT_EQ(wire::read_message(view.payload, message), wire::Fault::none);
    if (message.kind == wire::MessageKind::estimate) {
      estimate = message.estimate;
      ++estimates;
    } else {
      model = message.model;
      ++models;
    }
    return Status::ok;
  }
  bool deaf{};
  int estimates{}, models{};
  std::size_t size{};
  wire::EstimateMessage estimate{};
  wire::ModelMessage model{};
};

template <class S>
using Link = hal::PacketLink<tracker::Estimate<M, S>, Ear, hal::ManualClock>;
static_assert(hal::LinkPort<Link<double>, tracker::Estimate<M, double>>);
static_assert(hal::LinkPort<Link<float>, tracker::Estimate<M, float>>);

CameraParameters camera_in_the_robots_frame() {
  CameraParameters camera;
  camera.has_t_base_cam = true;
  camera.t_base_cam_m = {1, 2, 3};
  camera.r_base_cam_wxyz = {0, 1, 0, 0};
  return camera;
}

template <class S>
tracker::Estimate<M, S> random_estimate(test::Random& random) {
  tracker::Estimate<M, S> e;
  e.frame = 77, e.t_capture = {1'000'000'000}, e.valid = true, e.matched = 5, e.rms_px = S(0.25);
  e.status = tracker::TrackingStatus::degraded, e.reason = tracker::Reason::weak_joint;
  e.q = random.configuration<M, S>();
  e.qdot = random.vector<S, 8>(-1, 1);
  for (int i = 0; i < 8; ++i) e.covariance.col(i) = random.vector<S, 8>(-1, 1);
  e.covariance = (e.covariance + e.covariance.transpose()).eval();
  e.covariance.diagonal() = e.covariance.diagonal().cwiseAbs().eval();
  e.observability[7] = tracker::Observability::weak;
  return e;
}

template <class S>
void expect_every_number_to_arrive() {
  test::Random random{21};
  Ear ear;
  hal::ManualClock clock;
  clock.set({1'000'500'000});
  Link<S> link{ear, clock, {camera_in_the_robots_frame(), 99, 30}};
  const auto e = random_estimate<S>(random);
  ASSERT_EQ(link.publish(e), Status::ok);
  const wire::EstimateMessage& m = ear.estimate;
  EXPECT_EQ(m.session, 99u);
  EXPECT_EQ(m.model_hash, model::table_hash<M>());
  EXPECT_EQ(m.frame, 77u);
  EXPECT_EQ(m.t_capture, e.t_capture);
  EXPECT_EQ(m.t_send.ns, 1'000'500'000);
  EXPECT_EQ(m.status, e.status);
  EXPECT_EQ(m.reason, e.reason);
  EXPECT_EQ(m.matched, 5u);
  EXPECT_EQ(m.rms_px, 0.25);
  const auto& [R, t] = e.q.T_cam_obj;
  const S pose[]{t.x(), t.y(), t.z(), R.w(), R.x(), R.y(), R.z()};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(m.t_cam_obj[i], static_cast<double>(pose[i]));
  std::size_t k = 0;
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(m.velocity[static_cast<std::size_t>(i)], static_cast<double>(e.qdot[i]));
    EXPECT_EQ(m.observability[static_cast<std::size_t>(i)], e.observability[static_cast<std::size_t>(i)]);
    for (int j = i; j < 8; ++j) EXPECT_EQ(m.covariance[k++], static_cast<double>(e.covariance(i, j)));
  }
  for (int j = 0; j < 2; ++j) EXPECT_EQ(m.joints[static_cast<std::size_t>(j)], static_cast<double>(e.q.joints[j]));
}

TEST(PacketLink, EveryNumberArrivesToTheLastBitInDouble) { expect_every_number_to_arrive<double>(); }
TEST(PacketLink, EveryNumberArrivesToTheLastBitInFloat) { expect_every_number_to_arrive<float>(); }

TEST(PacketLink, GivesThePoseInTheRobotsFrameWhereTheCameraFileKnowsIt) {
  Ear ear;
  hal::ManualClock clock;
  tracker::Estimate<M, double> e;
  e.valid = true;
  e.q.T_cam_obj.t = {0.1, 0.2, 0.3};
  Link<double> with{ear, clock, {camera_in_the_robots_frame(), 1, 30}};
  ASSERT_EQ(with.publish(e), Status::ok);
  // Half a turn about x: y and z change their signs.
  const double expected[]{1.1, 1.8, 2.7, 0, 1, 0, 0};
  ASSERT_EQ(ear.estimate.t_base_obj.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(ear.estimate.t_base_obj[i], expected[i], 1e-15);  // some roundings
  EXPECT_EQ(ear.model.t_base_cam.size(), 7u);
  Link<double> without{ear, clock, {CameraParameters{}, 1, 30}};
  ASSERT_EQ(without.publish(e), Status::ok);
  EXPECT_TRUE(ear.estimate.t_base_obj.empty());
  EXPECT_TRUE(ear.model.t_base_cam.empty());
}

TEST(PacketLink, SendsNoNumbersWhereThereIsNoEstimate) {
  Ear ear;
  hal::ManualClock clock;
  Link<double> link{ear, clock, {camera_in_the_robots_frame(), 1, 30}};
  test::Random random{22};
  auto e = random_estimate<double>(random);
  e.valid = false, e.status = tracker::TrackingStatus::lost, e.matched = 0;
  e.rms_px = std::numeric_limits<double>::quiet_NaN();
  ASSERT_EQ(link.publish(e), Status::ok);
  EXPECT_EQ(ear.estimate.status, tracker::TrackingStatus::lost);
  EXPECT_TRUE(ear.estimate.t_cam_obj.empty() && ear.estimate.joints.empty() && ear.estimate.covariance.empty());
  EXPECT_EQ(ear.estimate.observability.size(), 8u);
}

TEST(PacketLink, SendsTheModelFirstAndThenOnceASecond) {
  Ear ear;
  hal::ManualClock clock;
  Link<double> link{ear, clock, {CameraParameters{}, 5, 30}};
  for (int k = 0; k < 90; ++k) {
    clock.set(from_seconds(7 + k / 30.0));
    ASSERT_EQ(link.publish({}), Status::ok);
    ASSERT_EQ(ear.models, 1 + k / 30);
    ASSERT_EQ(ear.estimate.number, static_cast<std::uint32_t>(k));
  }
  EXPECT_EQ(wire::view(ear.model.name), "printer_drawer");
  ASSERT_EQ(ear.model.joint_names.size(), 2u);
  EXPECT_EQ(wire::view(ear.model.joint_names[1]), "marker_distance");
  EXPECT_EQ(wire::unit(ear.model, 0), "m") << "the drawer slides";
  EXPECT_EQ(ear.model.rate_hz, 30);
  EXPECT_EQ(ear.model.session, 5u);
}

TEST(PacketLink, SaysSoWhenAnEstimateDoesNotGoOutAndItsNumberIsMissingThen) {
  Ear ear;
  hal::ManualClock clock;
  Link<double> link{ear, clock, {CameraParameters{}, 5, 30}};
  ASSERT_EQ(link.publish({}), Status::ok);
  ear.deaf = true;
  EXPECT_EQ(link.publish({}), Status::io_error);
  ear.deaf = false;
  ASSERT_EQ(link.publish({}), Status::ok);
  EXPECT_EQ(ear.estimate.number, 2u);
}

TEST(PacketLink, SendsAFaultWithoutNumbersInPlaceOfANumberThatIsNotFinite) {
  Ear ear;
  hal::ManualClock clock;
  clock.set({2'000'000'000});
  Link<double> link{ear, clock, {CameraParameters{}, 5, 30}};
  test::Random random{25};
  auto e = random_estimate<double>(random);
  e.covariance(3, 5) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(link.publish(e), Status::bad_argument);
  EXPECT_EQ(ear.estimates, 1);
  EXPECT_EQ(ear.estimate.frame, e.frame);
  EXPECT_FALSE(ear.estimate.valid);
  EXPECT_EQ(ear.estimate.status, tracker::TrackingStatus::fault);
  EXPECT_TRUE(ear.estimate.t_cam_obj.empty() && ear.estimate.joints.empty() && ear.estimate.covariance.empty());
  ear.deaf = true;
  EXPECT_EQ(link.publish(e), Status::io_error);
}

TEST(PacketLink, PublishingDoesNotTouchTheHeap) {
  if (!test::HeapTrap::works()) GTEST_SKIP() << "the heap cannot be replaced here (sanitizers bring their own)";
  test::Random random{23};
  Ear ear;
  hal::ManualClock clock;
  clock.set({2'000'000'000});
  Link<float> link{ear, clock, {camera_in_the_robots_frame(), 5, 30}};
  const auto e = random_estimate<float>(random);
  const test::HeapTrap trap;
  for (int k = 0; k < 100; ++k) (void)link.publish(e);
  EXPECT_EQ(trap.calls(), 0);
  EXPECT_EQ(ear.estimates, 100);
}

TEST(PacketLink, APacketOfThePrinterDrawerFitsIntoOneEthernetFrame) {
  Ear ear;
  hal::ManualClock clock;
  clock.set({2'000'000'000});
  Link<double> link{ear, clock, {camera_in_the_robots_frame(), hal::draw_session(), 30}};
  test::Random random{24};
  ASSERT_EQ(link.publish(random_estimate<double>(random)), Status::ok);
  constexpr std::size_t kEthernet = 1500 - 20 - 8;  // less the headers of IP and UDP
  EXPECT_LE(ear.size + wire::kTrailerSize, kEthernet);
  RecordProperty("packet_bytes", static_cast<int>(ear.size));
}

TEST(ToMessage, CutsALongNameBetweenTwoCharacters) {
  for (std::size_t before = 58; before < 64; ++before) {
    wire::Text text;
    hal::detail::put_text(text, std::string(before, 'a') + "\u00e9\u20ac\u00e9");
    const std::string_view cut = wire::view(text);
    EXPECT_LE(cut.size(), wire::kMaxName);
    const std::size_t rest = cut.size() - before;
    EXPECT_TRUE(rest == 0 || rest == 2 || rest == 5) << "2, 3 and 2 bytes a character";
  }
}

TEST(Session, IsAnotherOneAtEachStart) {
  EXPECT_NE(hal::draw_session(), hal::draw_session());
  EXPECT_NE(hal::draw_session(), 0u);
}

}  // namespace
}  // namespace articam
