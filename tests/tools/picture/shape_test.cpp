#include "tools/picture/shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/math/so3.hpp"

namespace articam::picture {
namespace {

constexpr int kRays = 2000;

class Shapes : public testing::TestWithParam<Shape> {
 protected:
  Vec3 random_vector() { return {normal_(engine_), normal_(engine_), normal_(engine_)}; }

  Shape placed() {
    Shape shape = GetParam();
    shape.T_cam_shape = {math::exp_so3<double>(random_vector()), 0.2 * random_vector()};
    return shape;
  }

  /// From outside towards some place near the middle.
  Ray ray_at(const Shape& shape) {
    const Vec3 origin = shape.T_cam_shape.t + 3 * random_vector().normalized();
    return {origin, shape.T_cam_shape.t + 0.4 * random_vector() - origin};
  }

  std::mt19937 engine_{20};
  std::normal_distribution<double> normal_;
};

/// How far a point of {shape} is outside; negative inside.
double outside(const Shape& shape, const Vec3& p) {
  const Vec3 half = 0.5 * shape.size;
  switch (shape.form) {
    case Form::box:
      return (p.cwiseAbs() - half).maxCoeff();
    case Form::cylinder:
      return std::max(p.head<2>().norm() - half.x(), std::abs(p.z()) - half.z());
    case Form::sphere:
      return p.norm() - half.x();
    default:
      return std::max(p.norm() - half.x(), std::abs(p.z()));
  }
}

TEST_P(Shapes, AreMetWhereTheirSurfaceIsAndNotBefore) {
  int hits = 0;
  for (int i = 0; i < kRays; ++i) {
    const Shape shape = placed();
    const Ray ray = ray_at(shape);
    const auto hit = meet(ray, shape);
    const auto outside_at = [&](double t) {
      return outside(shape, shape.T_cam_shape.inverse() * Vec3(ray.origin + t * ray.direction));
    };
    if (hit) {
      ++hits;
      EXPECT_NEAR(outside_at(hit->t), 0, 1e-12);
      EXPECT_NEAR(hit->normal_cam.norm(), 1, 1e-12);
      EXPECT_LT(hit->normal_cam.dot(ray.direction), 0) << "the side that faces the ray";
    }
    if (shape.form == Form::mark) continue;  // it has no inside
    const double end = hit ? hit->t : 2;
    for (double t = 0.01; t < end; t += 0.01) EXPECT_GT(outside_at(t), -1e-12);
  }
  EXPECT_GT(hits, kRays / 10);
}

std::string name_of(const testing::TestParamInfo<Shape>& test) {
  constexpr std::array kNames{"Box", "Cylinder", "Sphere", "Mark"};
  return kNames.at(static_cast<std::size_t>(test.param.form));
}

INSTANTIATE_TEST_SUITE_P(All, Shapes,
                         testing::Values(Shape{.form = Form::box, .size = {1, 0.6, 0.3}},
                                         Shape{.form = Form::cylinder, .size = {0.8, 0.8, 0.5}},
                                         Shape{.form = Form::sphere, .size = {0.9, 0.9, 0.9}},
                                         Shape{.form = Form::mark, .size = {1.4, 1, 0.4}}),
                         name_of);

TEST(Mark, IsSeenFromItsFrontAlone) {
  Shape mark{.form = Form::mark, .size = {0.14, 0.1, 0.04}};
  mark.T_cam_shape.t.z() = 1;  // its front looks along the ray
  EXPECT_FALSE(meet({Vec3::Zero(), Vec3::UnitZ()}, mark));
  mark.T_cam_shape.R = {0, 1, 0, 0};
  EXPECT_TRUE(meet({Vec3::Zero(), Vec3::UnitZ()}, mark));
}

TEST(Mark, IsInkedBetweenItsHoleAndItsEdge) {
  const Shape mark{.form = Form::mark,
                   .T_cam_shape = {{0, 1, 0, 0}, {0, 0, 1}},
                   .size = {0.14, 0.1, 0.04},
                   .colour = {1, 1, 1},
                   .ink = {0, 0, 0}};
  const auto red_at = [&](double x) { return meet({Vec3::Zero(), {x, 0, 1}}, mark)->colour[0]; };
  EXPECT_EQ(red_at(0.019), 1);
  EXPECT_EQ(red_at(0.021), 0);
  EXPECT_EQ(red_at(0.049), 0);
  EXPECT_EQ(red_at(0.051), 1);
  EXPECT_FALSE(meet({Vec3::Zero(), {0.071, 0, 1}}, mark));
}

}  // namespace
}  // namespace articam::picture
