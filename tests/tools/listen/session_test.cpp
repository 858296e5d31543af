#include "tools/listen/session.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/tools/listen/heard_estimate.hpp"

namespace articam::listen {
namespace {

class SessionTest : public testing::Test {
 protected:
  SessionTest() { estimate_.model_hash = model_.model_hash; }

  /// Sent so many ms after the session's start, on the way for so many.
  wire::Fault hear(std::uint32_t number, std::int64_t sent_ms, std::int64_t way_ms = 1, bool same_machine = false) {
    constexpr std::int64_t kMs = 1'000'000;
    estimate_.number = number;
    estimate_.t_capture.ns = (sent_ms - 10) * kMs, estimate_.t_send.ns = sent_ms * kMs;
    const std::int64_t at = (sent_ms + way_ms) * kMs;
    const Received received{{}, {same_machine ? at : at + 77 * kMs}, at + 99 * kMs, same_machine};
    const auto times = session_.take(estimate_, received);
    return times ? session_.deliver(estimate_, *times, deliver_) : wire::Fault::none;
  }

  test::Random random_{23};
  wire::EstimateMessage estimate_ = test::random_estimate(random_);
  wire::ModelMessage model_ = test::random_model(random_);
  std::vector<std::uint32_t> delivered_;
  std::vector<Times> times_;
  Session::Deliver deliver_ = [this](const Heard& heard) {
    delivered_.push_back(heard.estimate.number);
    times_.push_back(heard.times);
    EXPECT_EQ(heard.model.joint_names.size(), 2u);
  };
  Session session_;
};

TEST_F(SessionTest, KeepsEstimatesUntilTheirJointsHaveNamesAndThenGivesEachOnce) {
  for (const std::uint32_t number : {5u, 6u, 6u, 8u, 7u}) EXPECT_EQ(hear(number, number), wire::Fault::none);
  EXPECT_TRUE(delivered_.empty());
  EXPECT_EQ(session_.unnamed(), 4u);
  EXPECT_EQ(session_.take(model_, deliver_), wire::Fault::none);
  EXPECT_EQ(hear(9, 9), wire::Fault::none);
  EXPECT_EQ(hear(8, 9), wire::Fault::none);
  EXPECT_EQ(session_.take(model_, deliver_), wire::Fault::none) << "again every second";
  EXPECT_EQ(delivered_, (std::vector<std::uint32_t>{5, 6, 8, 7, 9}));
  EXPECT_EQ(session_.unnamed(), 0u);
}

TEST_F(SessionTest, KeepsNoMoreThanItsBound) {
  for (std::uint32_t number = 0; number < Session::kMaxWaiting + 3; ++number) (void)hear(number, number);
  (void)session_.take(model_, deliver_);
  EXPECT_EQ(delivered_.size(), Session::kMaxWaiting);
  EXPECT_EQ(delivered_.front(), 3u);
  EXPECT_EQ(session_.unnamed(), 3u);
}

TEST_F(SessionTest, RefusesAModelThatIsNotThatOfItsEstimates) {
  (void)hear(0, 0);
  auto other = model_;
  other.model_hash ^= 1;
  EXPECT_EQ(session_.take(other, deliver_), wire::Fault::wrong_model);
  EXPECT_EQ(session_.take(model_, deliver_), wire::Fault::wrong_model) << "it changed within a session";
  EXPECT_EQ(hear(1, 1), wire::Fault::wrong_model);
  EXPECT_TRUE(delivered_.empty());
}

TEST_F(SessionTest, RefusesAnEstimateWithMoreJointsThanNames) {
  auto short_model = model_;
  short_model.joint_names.clear();
  (void)session_.take(short_model, deliver_);
  EXPECT_EQ(hear(0, 0), wire::Fault::inconsistent);
  EXPECT_TRUE(delivered_.empty());
}

TEST_F(SessionTest, KnowsTheAgeExactlyOnOneMachineOnly) {
  (void)session_.take(model_, deliver_);
  (void)hear(0, 100, 3, true);
  EXPECT_DOUBLE_EQ(times_.back().age_s, 0.013);
  EXPECT_TRUE(times_.back().age_is_exact);
  Session other;
  session_ = other;
  (void)session_.take(model_, deliver_);
  (void)hear(0, 100, 3);
  EXPECT_DOUBLE_EQ(times_.back().age_s, 0.010) << "the quickest packet's way is not known";
  (void)hear(1, 200, 5);
  EXPECT_DOUBLE_EQ(times_.back().age_s, 0.012) << "2 ms slower than the quickest";
  EXPECT_FALSE(times_.back().age_is_exact);
  EXPECT_EQ(times_.back().t_send_wall_ns - times_.back().t_capture_wall_ns, 10'000'000);
  EXPECT_EQ(times_.back().receipt_wall_ns - times_.back().t_send_wall_ns, 2'000'000);
}

}  // namespace
}  // namespace articam::listen
