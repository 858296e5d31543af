/// @file  The start of every static model, its q0: a view in which all markers are seen and every joint is observed,
/// and from near which the firmware's tracker finds it.
#include "static_models/registry.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "hal/firmware.hpp"
#include "host_sim/world/object_state.hpp"
#include "static_models/cameras/mire_384x288.hpp"
#include "static_models/cameras/xtion_vga.hpp"

namespace articam::models {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using Vec2 = Vec<double, 2>;
using Vec3 = Vec<double, 3>;

constexpr CameraParameters camera_of(std::string_view model) {
  return model.starts_with("mire") ? cameras::kMire384x288 : cameras::kXtionVga;
}

template <class Model>
model::Configuration<Model, double> start() {
  return model::from_numbers<Model, double>(Model::kQ0).value();
}

/// Upper minus lower limit of each joint value; of a joint without limits a turn.
template <class Model>
VectorXd ranges() {
  VectorXd range(model::kNumJoints<Model>);
  for (Eigen::Index i = 0; i < range.size(); ++i) {
    const model::JointRow& row = model::kValueRows<Model>[static_cast<std::size_t>(i)];
    range[i] = row.q_max < model::kUnlimited ? row.q_max - row.q_min : 2 * std::numbers::pi;
  }
  return range;
}

/// Centres of all markers in the image, px, one below the other.
VectorXd pixels(const std::vector<sim::SceneMarker>& markers, const CameraParameters& parameters) {
  const vision::CameraModel<double> camera{parameters};
  VectorXd u(2 * static_cast<Eigen::Index>(markers.size()));
  Eigen::Index row = 0;
  for (const auto& marker : markers) {
    u.segment<2>(row) = camera.project(marker.centre_cam_m.hnormalized());
    row += 2;
  }
  return u;
}

/// d pixels / d step by central differences, step ordered (t, rotation, joints).
template <class Model>
MatrixXd numeric_articulation_matrix() {
  constexpr double kStep = 1e-6;  // truncation and cancellation both below 1e-6 of a column
  constexpr int kDof = model::kDof<Model>;
  MatrixXd A(2 * model::kNumMarkers<Model>, kDof);
  for (int i = 0; i < kDof; ++i) {
    const Vec<double, kDof> step = kStep * Vec<double, kDof>::Unit(i);
    const auto at = [&](const Vec<double, kDof>& by) {
      return pixels(sim::scene_markers<Model>(model::integrate(start<Model>(), by)), camera_of(Model::kName));
    };
    A.col(i) = (at(step) - at(-step)) / (2 * kStep);
  }
  return A;
}

/// Least standard deviation of every degree of freedom at a noise of 1 px in every coordinate (Cramer-Rao).
VectorXd least_deviations(const MatrixXd& A) { return (A.transpose() * A).inverse().diagonal().cwiseSqrt(); }

struct Outline {
  Vec2 centre_px;
  double largest_px{}, smallest_px{};  ///< diameters of its image
  bool inside{};                       ///< with its card, 1.4 times as wide
};

Outline outline_of(const sim::SceneMarker& marker, const CameraParameters& parameters) {
  const vision::CameraModel<double> camera{parameters};
  constexpr int kSides = 16;
  const Vec3 e1 = marker.normal_cam.unitOrthogonal(), e2 = marker.normal_cam.cross(e1);
  const auto at = [&](double radius_m, int i) -> Vec2 {
    const double angle = 2 * std::numbers::pi / kSides * i;
    const Vec3 out = std::cos(angle) * e1 + std::sin(angle) * e2;
    return camera.project((marker.centre_cam_m + radius_m * out).hnormalized());
  };
  Outline outline{camera.project(marker.centre_cam_m.hnormalized()), 0, 1e9, true};
  for (int i = 0; i < kSides; ++i) {
    const double diameter_px = (at(marker.outer_radius_m, i) - at(marker.outer_radius_m, i + kSides / 2)).norm();
    outline.largest_px = std::max(outline.largest_px, diameter_px);
    outline.smallest_px = std::min(outline.smallest_px, diameter_px);
    const Vec2 edge = at(1.4 * marker.outer_radius_m, i);
    outline.inside = outline.inside && edge.minCoeff() > 0 && edge.x() < parameters.width_px - 1 &&
                     edge.y() < parameters.height_px - 1;
  }
  return outline;
}

class Start : public testing::TestWithParam<std::string_view> {};

TEST_P(Start, ShowsEveryMarkerFacingTheCameraWhollyInTheImage) {
  visit_model(GetParam(), []<class Model>() {
    const auto markers = sim::scene_markers<Model>(start<Model>());
    for (std::size_t i = 0; i < markers.size(); ++i) {
      SCOPED_TRACE(Model::kMarkers[i].name);
      EXPECT_GT(markers[i].centre_cam_m.z(), 0);
      EXPECT_LT(markers[i].normal_cam.dot(markers[i].centre_cam_m), 0);
      const Outline outline = outline_of(markers[i], camera_of(Model::kName));
      EXPECT_TRUE(outline.inside);
      // The disc of the same area. Smaller ones are found, too, but leave no room to move away.
      EXPECT_GE(std::sqrt(outline.largest_px * outline.smallest_px), 12);
    }
  });
}

TEST_P(Start, ShowsTheMarkersApart) {
  visit_model(GetParam(), []<class Model>() {
    std::vector<Outline> outlines;
    for (const auto& marker : sim::scene_markers<Model>(start<Model>())) {
      outlines.push_back(outline_of(marker, camera_of(Model::kName)));
    }
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double touching_px = 0.5 * (outlines[i].largest_px + outlines[j].largest_px);
        EXPECT_GT((outlines[i].centre_px - outlines[j].centre_px).norm(), 1.2 * touching_px)
            << Model::kMarkers[i].name << ", " << Model::kMarkers[j].name;
      }
    }
  });
}

TEST_P(Start, HasItsJointsInsideTheirLimits) {
  visit_model(GetParam(), []<class Model>() {
    const auto q = start<Model>();
    for (int i = 0; i < model::kNumJoints<Model>; ++i) {
      const model::JointRow& row = model::kValueRows<Model>[static_cast<std::size_t>(i)];
      EXPECT_GE(q.joints[i], row.q_min) << row.name;
      EXPECT_LE(q.joints[i], row.q_max) << row.name;
    }
  });
}

// 0.3 px is a poor measurement: the detector errs by some hundredths on marks of this size.
TEST_P(Start, TellsTheEndsOfEveryJointApartByTenDeviationsAtANoiseOfThreeTenthsOfAPixel) {
  visit_model(GetParam(), []<class Model>() {
    const MatrixXd A = numeric_articulation_matrix<Model>();
    const VectorXd singular = A.colwise().normalized().jacobiSvd().singularValues();
    testing::Test::RecordProperty("smallest_singular_value", std::to_string(singular.tail<1>()[0]));
    EXPECT_GT(singular.tail<1>()[0], 0.05) << "of columns scaled to 1: some motion is nearly another one";
    const VectorXd deviations = 0.3 * least_deviations(A).tail(model::kNumJoints<Model>);
    const VectorXd range = ranges<Model>();
    for (Eigen::Index i = 0; i < range.size(); ++i) {
      EXPECT_LT(deviations[i], 0.1 * range[i]) << model::kValueRows<Model>[static_cast<std::size_t>(i)].name;
    }
  });
}

/// Off by 5 mm and 1 degree along and about every axis, and by a fiftieth of each joint's range, signs in turn.
template <class Model>
model::Configuration<Model, double> nearby() {
  Vec<double, model::kDof<Model>> off;
  off.template head<3>().setConstant(0.005);
  off.template segment<3>(3).setConstant(std::numbers::pi / 180);
  off.template tail<model::kNumJoints<Model>>() = 0.02 * ranges<Model>();
  for (int i = 1; i < model::kDof<Model>; i += 2) off[i] = -off[i];
  return model::integrate(start<Model>(), off);
}

TEST_P(Start, IsFoundByTheTrackerFromNearby) {
  visit_model(GetParam(), []<class Model>() {
    constexpr CameraParameters kCamera = camera_of(Model::kName);
    const auto truth = start<Model>();
    sim::Renderer renderer{kCamera, {}};
    std::vector<std::uint8_t> frame;
    renderer.render(sim::scene_markers<Model>(truth), 0, frame);
    const auto tracker = std::make_unique<tracker::Tracker<Model, double>>(kCamera);
    tracker->set_start(nearby<Model>());
    const auto estimate =
        tracker->step({frame.data(), kCamera.width_px, kCamera.height_px, kCamera.width_px}, Timestamp{});
    EXPECT_EQ(estimate.status, tracker::TrackingStatus::tracking) << "reason " << static_cast<int>(estimate.reason);
    EXPECT_EQ(estimate.matched, model::kNumMarkers<Model>);
    // Four deviations of a detector that errs by 0.1 px.
    const VectorXd bound = 4 * 0.1 * least_deviations(numeric_articulation_matrix<Model>());
    const auto error = model::difference(estimate.q, truth);
    for (int i = 0; i < model::kDof<Model>; ++i) EXPECT_LT(std::abs(error[i]), bound[i]) << "degree of freedom " << i;
  });
}

INSTANTIATE_TEST_SUITE_P(All, Start, testing::ValuesIn(kStaticModelNames),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace articam::models
