#include "tools/listen/session.hpp"

#include <utility>

namespace articam::listen {
namespace {

wire::Fault compare(const wire::EstimateMessage& estimate, const wire::ModelMessage& model) {
  if (estimate.model_hash != model.model_hash) return wire::Fault::wrong_model;
  const bool fits = !estimate.valid || estimate.joints.size() == model.joint_names.size();
  return fits ? wire::Fault::none : wire::Fault::inconsistent;
}

}  // namespace

std::optional<Times> Session::take(const wire::EstimateMessage& estimate, const Received& received) {
  const bool is_first = sequence_.counts().received == 0;
  if (!sequence_.take(estimate.number)) return std::nullopt;
  if (is_first) t_first_ = estimate.t_capture;
  to_wall_.take(estimate.t_send.ns, received.at_wall_ns);
  to_monotonic_.take(estimate.t_send.ns, received.at.ns);
  const Timestamp capture{received.same_machine ? estimate.t_capture.ns
                                                : to_monotonic_.to_host_ns(estimate.t_capture.ns)};
  return Times{.receipt_wall_ns = received.at_wall_ns,
               .t_send_wall_ns = to_wall_.to_host_ns(estimate.t_send.ns),
               .t_capture_wall_ns = to_wall_.to_host_ns(estimate.t_capture.ns),
               .age_s = seconds_between(capture, received.at),
               .age_is_exact = received.same_machine};
}

wire::Fault Session::deliver(const wire::EstimateMessage& estimate, const Times& times, const Deliver& to) {
  if (model_) {
    const wire::Fault fault = compare(estimate, *model_);
    if (fault == wire::Fault::none) to({estimate, *model_, t_first_, times});
    return fault;
  }
  if (waiting_.size() == kMaxWaiting) waiting_.pop_front(), ++dropped_;
  waiting_.push_back({estimate, times});
  return wire::Fault::none;
}

wire::Fault Session::take(const wire::ModelMessage& model, const Deliver& to) {
  if (model_) return model_->model_hash == model.model_hash ? wire::Fault::none : wire::Fault::wrong_model;
  model_ = model;
  wire::Fault worst = wire::Fault::none;
  for (const auto& [estimate, times] : std::exchange(waiting_, {})) {
    const wire::Fault fault = deliver(estimate, times, to);
    if (fault != wire::Fault::none) worst = fault, ++dropped_;
  }
  return worst;
}

}  // namespace articam::listen
