#include "tools/identify/judge_camera.hpp"

#include <cmath>

namespace articam::identify {
namespace {

using Lens = Vec<double, 2>;

/// How much farther out a lens shows the point when its first two coefficients grow, px.
Lens outwards(const CameraParameters& camera, const Vec<double, 2>& s) {
  constexpr double kStep = 1e-3;
  const vision::CameraModel<double> model{camera};
  const Vec<double, 2> axis{camera.cx_px, camera.cy_px};
  const Vec<double, 2> ray = (model.project(s) - axis).normalized();
  Lens slope;
  for (int i = 0; i < 2; ++i) {
    CameraChange change;
    change.by[CameraChange::kK1 + i] = kStep;
    slope[i] = ray.dot(vision::CameraModel<double>{changed(camera, change)}.project(s) - model.project(s)) / kStep;
  }
  return slope;
}

}  // namespace

double Judgement::significance() const { return std::abs(error) / deviation; }

bool Judgement::wrong() const {
  constexpr double kSignificant = 4, kMatters_px = 0.1;  // the latter is what a detector may be wrong by, everywhere
  return told && significance() > kSignificant && effect_px > kMatters_px;
}

std::vector<Judgement> judge_camera(const CameraParameters& camera, const Constants& constants, const VectorXd& x,
                                    const MatrixXd& covariance, const Vec<double, 2>& outermost_px) {
  constexpr int n = CameraChange::kSize;
  const CameraChange change = constants.change(x);
  const Mat<double, n, n> C = covariance.block<n, n>(constants.camera(), constants.camera());
  const Vec<double, n> known = prior_of(constants, camera).information.segment<n>(constants.camera());
  const Vec<double, 2> arm = outermost_px - Vec<double, 2>{camera.cx_px, camera.cy_px};
  std::vector<Judgement> judgements;
  /// A combination of the six numbers, and how many pixels its unit moves the outermost mark.
  const auto judge = [&](Judgement::Part part, const Vec<double, n>& of, double per_unit_px) {
    constexpr double kTold = 0.5;  // of what is known without a recording
    const double error = of.dot(change.by), deviation = std::sqrt(of.dot(C * of));
    const double before = std::sqrt(of.cwiseAbs2().dot(known.cwiseInverse()));
    judgements.push_back({part, error, deviation, std::abs(error) * per_unit_px, deviation < kTold * before});
  };
  const auto unit = [](int i) -> Vec<double, n> { return Vec<double, n>::Unit(i); };
  judge(Judgement::Part::focal_length, unit(CameraChange::kFocal), arm.norm());
  judge(Judgement::Part::aspect, unit(CameraChange::kAspect), 0.5 * arm.norm());
  judge(Judgement::Part::principal_x, unit(CameraChange::kCx), 1);
  judge(Judgement::Part::principal_y, unit(CameraChange::kCy), 1);
  const auto s = vision::CameraModel<double>{camera}.unproject(outermost_px);
  if (!s.ok()) return judgements;
  Vec<double, n> lens = Vec<double, n>::Zero();
  lens.segment<2>(CameraChange::kK1) = outwards(camera, s.value());
  judge(Judgement::Part::distortion, lens, 1);
  return judgements;
}

}  // namespace articam::identify
