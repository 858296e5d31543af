#pragma once
/// @file  An estimate as one line of estimates.csv.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "core/tracker/estimate.hpp"

namespace articam::hal {

/// Text of bounded length, without heap and without locale. What does not fit is dropped and overflowed() tells.
template <std::size_t Capacity>
class LineBuffer {
 public:
  void clear() noexcept { size_ = 0, overflowed_ = false; }
  std::string_view text() const noexcept { return {text_, size_}; }
  bool overflowed() const noexcept { return overflowed_; }

  void put(std::string_view text) noexcept {
    const std::size_t fits = std::min(text.size(), Capacity - size_);
    if (fits < text.size()) overflowed_ = true;
    std::copy_n(text.data(), fits, text_ + size_);
    size_ += fits;
  }
  /// The shortest text that reads back as the same number.
  template <class Number>
  void put_number(Number x) noexcept {
    const auto [end, error] = std::to_chars(text_ + size_, text_ + Capacity, x);
    if (error == std::errc{})
      size_ = static_cast<std::size_t>(end - text_);
    else
      overflowed_ = true;
  }

 private:
  char text_[Capacity];
  std::size_t size_{};
  bool overflowed_{};
};

/// Enough for the columns below: at most 26 characters a number, names up to 64.
template <class Model>
using CsvLine = LineBuffer<64 * static_cast<std::size_t>(24 + 4 * model::kNumJoints<Model>)>;

/// `frame,t_s,status,reason,px,...,matched,rms_px`, with the model's joint names. No line end.
template <class Model>
void put_csv_header(CsvLine<Model>& line) noexcept {
  line.put("frame,t_s,status,reason,px,py,pz,qw,qx,qy,qz");
  for (const auto& joint : model::kValueRows<Model>) line.put(","), line.put(joint.name);
  line.put(",std_px,std_py,std_pz,std_rx,std_ry,std_rz");
  for (const auto& joint : model::kValueRows<Model>) line.put(",std_"), line.put(joint.name);
  line.put(",matched,rms_px");
}

/// One estimate; the fields of q and of its deviations are empty where it is not valid. SI units; pose of {obj} in
/// {cam}.
template <class Model, class S>
void put_csv_row(const tracker::Estimate<Model, S>& estimate, CsvLine<Model>& line) noexcept {
  const auto field = [&](auto x) { line.put(","), line.put_number(x); };
  line.put_number(estimate.frame);
  field(static_cast<double>(estimate.t_capture.ns) / 1e9);
  line.put(","), line.put(name(estimate.status)), line.put(","), line.put(name(estimate.reason));
  constexpr int kNumbers = 7 + model::kNumJoints<Model> + model::kDof<Model>;
  if (estimate.valid) {
    const auto& [R, t] = estimate.q.T_cam_obj;
    for (const S x : {t.x(), t.y(), t.z(), R.w(), R.x(), R.y(), R.z()}) field(x);
    for (int j = 0; j < model::kNumJoints<Model>; ++j) field(estimate.q.joints[j]);
    for (int i = 0; i < model::kDof<Model>; ++i) field(std::sqrt(estimate.covariance(i, i)));
  } else {
    for (int i = 0; i < kNumbers; ++i) line.put(",");
  }
  field(estimate.matched);
  if (estimate.matched > 0)
    field(estimate.rms_px);
  else
    line.put(",");
}

}  // namespace articam::hal
