#pragma once
/// @file  Every bit of what the detector saw and of what the tracker says, as one number each.
///
/// A step of FNV-1a is a bijection of the hash for a given byte, and different bytes lead to different hashes: two
/// inputs of the same length that differ in a single byte never collide.

#include <bit>
#include <concepts>
#include <cstdint>
#include <span>

#include "core/model/table_hash.hpp"
#include "core/tracker/estimate.hpp"
#include "core/vision/detection.hpp"

namespace articam::test {

class BitHash {
 public:
  void put(std::integral auto x) noexcept { hash_.put(static_cast<std::uint64_t>(x)); }
  void put(float x) noexcept { put(std::bit_cast<std::uint32_t>(x)); }
  void put(double x) noexcept { hash_.put(x); }
  std::uint64_t value() const noexcept { return hash_.value(); }

 private:
  model::Fnv1a hash_;
};

inline std::uint64_t hash_of(std::span<const std::uint8_t> pixels) noexcept {
  BitHash hash;
  for (const std::uint8_t pixel : pixels) hash.put(pixel);
  return hash.value();
}

inline std::uint64_t hash_of(const vision::Detections& detections) noexcept {
  BitHash hash;
  hash.put(detections.size());
  for (const vision::Detection& detection : detections) {
    hash.put(static_cast<std::uint8_t>(detection.kind));
    for (const vision::Ellipse& e : {detection.outer, detection.inner}) {
      for (const std::int32_t x : {e.u_q16, e.v_q16, e.m00_q16, e.m10_q16, e.m11_q16}) hash.put(x);
    }
    hash.put(detection.flaws);
    hash.put(detection.blur_q8);
    for (const std::uint32_t x : {detection.centre_variance_q24, detection.axis_variance_q24,
                                  detection.inner_centre_variance_q24, detection.inner_axis_variance_q24})
      hash.put(x);
  }
  return hash.value();
}

template <class Model, class S>
std::uint64_t hash_of(const tracker::Estimate<Model, S>& estimate) noexcept {
  BitHash hash;
  hash.put(estimate.frame);
  hash.put(estimate.t_capture.ns);
  hash.put(static_cast<std::uint8_t>(estimate.status));
  hash.put(static_cast<std::uint8_t>(estimate.reason));
  hash.put(static_cast<std::uint8_t>(estimate.valid));
  for (const S x : estimate.q.T_cam_obj.t) hash.put(x);
  for (const S x : estimate.q.T_cam_obj.R.coeffs()) hash.put(x);
  for (const S x : estimate.q.joints) hash.put(x);
  for (const S x : estimate.qdot) hash.put(x);
  for (const S x : estimate.covariance.reshaped()) hash.put(x);
  for (const tracker::Observability x : estimate.observability) hash.put(static_cast<std::uint8_t>(x));
  hash.put(estimate.matched);
  hash.put(estimate.rms_px);
  hash.put(estimate.error_norm);
  hash.put(estimate.iterations);
  return hash.value();
}

}  // namespace articam::test
