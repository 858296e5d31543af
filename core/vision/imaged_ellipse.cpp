#include "core/vision/imaged_ellipse.hpp"

#include "core/vision/moving_shape.hpp"

namespace articam::vision {
namespace {

template <class S>
struct CircleImage {
  Plate<S> plate;
  math::Triple<S> c;
  Vec<S, 2> s;
  MovingShape<S> shape;

  CircleImage(const Circle<S>& circle, const Vec<S, 2>& centre) noexcept
      : plate{math::to_triple(circle.normal), circle.radius},
        c{math::to_triple(circle.centre)},
        s{centre},
        shape{plate, c, {plate, c, s.x(), s.y(), S(1) / (c.z * c.z + plate.N_z)}} {}

  PlaneEllipse<S> ellipse() const noexcept {
    PlaneEllipse<S> e;
    e.centre = s;
    e.M << shape.m00, S(0), shape.m10, shape.m11;
    return e;
  }
};

}  // namespace

template <class S>
Result<PlaneEllipse<S>> imaged_ellipse(const Circle<S>& circle) noexcept {
  const auto centre = imaged_centre(circle);
  if (!centre.ok()) return centre.status();
  const CircleImage<S> image{circle, centre.value()};
  if (!image.shape.exists()) return Status::ill_conditioned;
  return image.ellipse();
}

template <class S>
Result<MovingEllipse<S>> moving_ellipse(const Circle<S>& circle) noexcept {
  const auto centre = imaged_centre(circle);
  if (!centre.ok()) return centre.status();
  CircleImage<S> image{circle, centre.value()};
  if (!image.shape.exists()) return Status::ill_conditioned;
  // Seen from the camera the circle turns about it, the other way.
  image.shape.move(image.plate, image.c, image.c, {}, S(-1));
  const auto& [f_x, f_y, f_z] = image.shape.f;
  const auto& [w_x, w_y, w_z] = image.shape.w;
  MovingEllipse<S> moving;
  moving.ellipse = image.ellipse();
  moving.L.template topRows<2>() = imaged_centre_interaction_matrix(circle).value();
  moving.L.template bottomRows<3>() << f_x.x, S(0), f_z.x, w_x.x, w_y.x, w_z.x,  //
      f_x.y, f_y.y, f_z.y, w_x.y, w_y.y, w_z.y,                                  //
      f_x.z, f_y.z, f_z.z, w_x.z, w_y.z, w_z.z;
  return moving;
}

template Result<PlaneEllipse<float>> imaged_ellipse(const Circle<float>&) noexcept;
template Result<PlaneEllipse<double>> imaged_ellipse(const Circle<double>&) noexcept;
template Result<MovingEllipse<float>> moving_ellipse(const Circle<float>&) noexcept;
template Result<MovingEllipse<double>> moving_ellipse(const Circle<double>&) noexcept;

}  // namespace articam::vision
