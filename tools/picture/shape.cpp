#include "tools/picture/shape.hpp"

#include <cmath>

namespace articam::picture {
namespace {

/// In {shape}.
struct Entry {
  double t{};
  Vec3 normal;
};

std::optional<Entry> enter_box(const Vec3& from, const Vec3& along, const Vec3& half) {
  Entry entry{-1e9, Vec3::Zero()};
  double leave = 1e9;
  for (int i = 0; i < 3; ++i) {
    if (along[i] == 0 && std::abs(from[i]) > half[i]) return std::nullopt;
    if (along[i] == 0) continue;
    const double side = along[i] > 0 ? -1 : 1;  // the face that is met first
    const double t = (side * half[i] - from[i]) / along[i];
    leave = std::min(leave, (-side * half[i] - from[i]) / along[i]);
    if (t > entry.t) entry = {t, side * Vec3::Unit(i)};
  }
  return entry.t < leave ? std::optional{entry} : std::nullopt;
}

/// The first root of |p + t a|^2 = r^2, the points taken as they are.
std::optional<double> first_root(const Vec3& p, const Vec3& a, double r) {
  const double aa = a.squaredNorm(), pa = p.dot(a);
  const double discriminant = pa * pa - aa * (p.squaredNorm() - r * r);
  if (aa == 0 || discriminant < 0) return std::nullopt;
  return (-pa - std::sqrt(discriminant)) / aa;
}

std::optional<Entry> enter_sphere(const Vec3& from, const Vec3& along, double radius) {
  const auto t = first_root(from, along, radius);
  if (!t) return std::nullopt;
  return Entry{*t, (from + *t * along) / radius};
}

std::optional<Entry> enter_cylinder(const Vec3& from, const Vec3& along, double radius, double half_length) {
  const Vec3 flat(1, 1, 0);
  if (const auto t = first_root(from.cwiseProduct(flat), along.cwiseProduct(flat), radius)) {
    const Vec3 at = from + *t * along;
    if (std::abs(at.z()) <= half_length) return Entry{*t, at.cwiseProduct(flat) / radius};
  }
  if (along.z() == 0) return std::nullopt;
  const double side = along.z() > 0 ? -1 : 1;
  const double t = (side * half_length - from.z()) / along.z();
  const Vec3 at = from + t * along;
  if (at.head<2>().norm() > radius) return std::nullopt;
  return Entry{t, side * Vec3::UnitZ()};
}

}  // namespace

std::optional<Hit> meet(const Ray& ray, const Shape& shape) {
  const Pose<double> T_shape_cam = shape.T_cam_shape.inverse();
  const Vec3 from = T_shape_cam * ray.origin, along = T_shape_cam.R * ray.direction;
  const Vec3 half = 0.5 * shape.size;
  Colour colour = shape.colour;
  std::optional<Entry> entry;
  switch (shape.form) {
    case Form::box:
      entry = enter_box(from, along, half);
      break;
    case Form::cylinder:
      entry = enter_cylinder(from, along, half.x(), half.z());
      break;
    case Form::sphere:
      entry = enter_sphere(from, along, half.x());
      break;
    case Form::mark:
      if (along.z() >= 0) return std::nullopt;
      entry = Entry{-from.z() / along.z(), Vec3::UnitZ()};
      const double r = (from + entry->t * along).norm();
      if (r > half[0]) return std::nullopt;
      if (r <= half[1] && r > half[2]) colour = shape.ink;
      break;
  }
  if (!entry || !(entry->t > 0)) return std::nullopt;
  return Hit{entry->t, shape.T_cam_shape.R * entry->normal, colour};
}

}  // namespace articam::picture
