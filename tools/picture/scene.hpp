#pragma once
/// @file  An object's files -> what a camera has before it at the start of the tracker.

#include <optional>
#include <string>
#include <vector>

#include "core/camera_parameters.hpp"
#include "tools/modelgen/diagnostics.hpp"
#include "tools/modelgen/source_file.hpp"
#include "tools/picture/shape.hpp"

namespace articam::picture {

struct Scene {
  std::vector<Shape> shapes;         ///< the visuals of all links, then the marks
  std::vector<std::string> markers;  ///< names of the marks
};

/// The object as its URDF draws it, at the q0 of its markers file, every mark on a card of 1.4 times its diameter as in
/// the simulator. Nothing when the diagnostics hold an error.
/// Errors  those of the model compiler and of read_visuals; a markers file without q0.
std::optional<Scene> scene_of(const modelgen::SourceFile& urdf, const modelgen::SourceFile& markers,
                              modelgen::Diagnostics& diagnostics);

/// The first shape that the ray meets, and where.
struct Sight {
  const Shape* shape{};
  Hit hit;
};
std::optional<Sight> first_met(const Ray& ray, const std::vector<Shape>& shapes);

/// Names of the marks that are not wholly in the picture, or not before the camera.
std::vector<std::string> cut_markers(const Scene& scene, const CameraParameters& camera);

/// Names of the marks of which the camera at the origin does not see the whole: turned away, or behind something.
std::vector<std::string> hidden_markers(const Scene& scene);

}  // namespace articam::picture
