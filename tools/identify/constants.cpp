#include "tools/identify/constants.hpp"

namespace articam::identify {

Prior prior_of(const Constants& constants, const CameraParameters& camera) {
  constexpr double kPlace_m = 0.01, kFocal = 0.05, kAspect = 0.02, kPrincipal = 0.05, kLens = 0.3, kPrint = 0.005;
  const double principal_px = kPrincipal * camera.width_px;
  VectorXd deviation = VectorXd::Constant(constants.size(), 0);
  deviation.segment(constants.places(), constants.num_places()).setConstant(kPlace_m);
  deviation.segment<CameraChange::kSize>(constants.camera()) << kFocal, kAspect, principal_px, principal_px, kLens,
      kLens;
  deviation[constants.radius()] = kPrint;
  return {VectorXd::Zero(constants.size()),
          deviation.unaryExpr([](double sigma) { return sigma > 0 ? 1 / (sigma * sigma) : 0.0; })};
}

}  // namespace articam::identify
