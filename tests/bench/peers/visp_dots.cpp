#include "tests/bench/peers/visp_dots.hpp"

#include <visp3/blob/vpDot2.h>

namespace articam::bench {

struct VispDots::Tracked {
  vpImage<unsigned char> image;
  std::vector<vpDot2> dots;
};

VispDots::VispDots(std::vector<std::uint8_t> grey, const std::vector<Place>& start)
    : tracked_{std::make_unique<Tracked>()} {
  tracked_->image = vpImage<unsigned char>(grey.data(), 480, 640, true);
  tracked_->dots.resize(start.size());
  for (std::size_t i = 0; i < start.size(); ++i) {
    tracked_->dots[i].initTracking(tracked_->image, vpImagePoint(start[i].v_px, start[i].u_px));
  }
}

VispDots::~VispDots() = default;

void VispDots::track() {
  for (vpDot2& dot : tracked_->dots) dot.track(tracked_->image);
}

std::vector<Place> VispDots::centres() const {
  std::vector<Place> centres;
  for (const vpDot2& dot : tracked_->dots) centres.push_back({dot.getCog().get_u(), dot.getCog().get_v()});
  return centres;
}

}  // namespace articam::bench
