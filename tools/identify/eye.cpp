#include "tools/identify/eye.hpp"

#include <cmath>

#include "core/vision/imaged_ellipse.hpp"
#include "core/vision/lens_ellipse.hpp"

namespace articam::identify {
namespace {

constexpr double kStep_m = 1e-4, kStepNormal = 1e-3, kStepRadius = 1e-2, kStepLens = 1e-3;

}  // namespace

CameraParameters changed(const CameraParameters& camera, const CameraChange& change) {
  using Index = CameraChange;
  CameraParameters result = camera;
  result.fx_px *= std::exp(change.by[Index::kFocal] - 0.5 * change.by[Index::kAspect]);
  result.fy_px *= std::exp(change.by[Index::kFocal] + 0.5 * change.by[Index::kAspect]);
  result.cx_px += change.by[Index::kCx];
  result.cy_px += change.by[Index::kCy];
  result.distortion[0] += change.by[Index::kK1];  // of all three lens models the first two are of r^2 and r^4
  result.distortion[1] += change.by[Index::kK2];
  return result;
}

Eye::Eye(const CameraParameters& camera, const CameraChange& change) : model_{changed(camera, change)} {
  for (const int i : {CameraChange::kK1, CameraChange::kK2}) {
    for (const double sign : {-1.0, 1.0}) {
      CameraChange moved = change;
      moved.by[i] += sign * kStepLens;
      beside_.emplace_back(changed(camera, moved));
    }
  }
}

std::optional<Vec<double, 2>> Eye::pixel(const vision::Circle<double>& circle, const Camera& camera) {
  const auto on_plane = vision::imaged_ellipse(circle);
  if (!on_plane.ok()) return std::nullopt;
  const auto image = vision::distorted_ellipse(on_plane.value(), camera);
  if (!image.ok()) return std::nullopt;
  return image.value().centre;
}

std::optional<Sight> Eye::see(const vision::Circle<double>& circle) const {
  Sight sight;
  bool seen = true;
  const auto look = [&seen](const vision::Circle<double>& at, const Camera& camera) -> Vec<double, 2> {
    const auto found = pixel(at, camera);
    seen = seen && found;
    return found.value_or(Vec<double, 2>::Zero());
  };
  /// d pixel / d number, `by` the circle with that number moved.
  const auto slope = [&](double step, auto&& by) -> Vec<double, 2> {
    return (look(by(step), model_) - look(by(-step), model_)) / (2 * step);
  };
  sight.pixel = look(circle, model_);
  for (int i = 0; i < 3; ++i) {
    sight.by_centre.col(i) = slope(kStep_m, [&](double h) {
      auto moved = circle;
      moved.centre[i] += h;
      return moved;
    });
    sight.by_normal.col(i) = slope(kStepNormal, [&](double h) {
      auto moved = circle;
      moved.normal[i] += h;
      return moved;
    });
  }
  sight.by_log_radius = slope(kStepRadius, [&](double h) {
    auto moved = circle;
    moved.radius *= std::exp(h);
    return moved;
  });
  const auto& p = model_.parameters();
  const Vec<double, 2> from_axis = sight.pixel - Vec<double, 2>{p.cx_px, p.cy_px};
  sight.by_camera << from_axis.x(), -0.5 * from_axis.x(), 1, 0, 0, 0,  //
      from_axis.y(), 0.5 * from_axis.y(), 0, 1, 0, 0;
  for (int i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(2 * i);
    sight.by_camera.col(CameraChange::kK1 + i) =
        (look(circle, beside_[k + 1]) - look(circle, beside_[k])) / (2 * kStepLens);
  }
  return seen ? std::optional{sight} : std::nullopt;
}

}  // namespace articam::identify
