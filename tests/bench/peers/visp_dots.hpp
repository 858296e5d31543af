#pragma once
/// @file  ViSP's dot tracker behind plain types: its headers are C++17, ours C++20.

#include <cstdint>
#include <memory>
#include <vector>

namespace articam::bench {

struct Place {
  double u_px, v_px;
};

class VispDots {
 public:
  /// `grey` is 640x480 without gaps.
  VispDots(std::vector<std::uint8_t> grey, const std::vector<Place>& start);
  ~VispDots();

  void track();
  std::vector<Place> centres() const;

 private:
  struct Tracked;
  std::unique_ptr<Tracked> tracked_;
};

}  // namespace articam::bench
