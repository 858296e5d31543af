#pragma once
/// @file  A model made to find mistakes: every joint kind, oblique axes, a branch, turned frames.

#include "core/model/model_table.hpp"

namespace articam::test {

//   base  [corner, front]
//   |-- hinge (revolute) --> flap  [flap_ring]
//   |   `-- rod (prismatic) --> slider  [slider_ring, slider_dot]
//   |       `-- knob (continuous) --> wheel  [wheel_ring]
//   `-- lid (revolute) --> cover  [cover_ring]
struct Arm {
  using enum model::JointKind;
  using enum model::MarkerKind;
  static constexpr std::string_view kName = "arm";
  // clang-format off
  static constexpr std::array<model::JointRow, 4> kJoints{{
    {"hinge", revolute,   -1, {0.6, 0, 0.8},   { 0.10,  0.05, -0.02}, {0.5, 0.5, -0.5, 0.5}, -1.5, 1.5},
    {"rod",   prismatic,   0, {0, -0.28, 0.96}, {0.03, -0.08,  0.04}, {0.8, 0, 0.6, 0},       0.0, 0.3},
    {"knob",  continuous,  1, {0, 1, 0},       {-0.02,  0.06,  0.01}, {0.5, -0.5, 0.5, 0.5}, -1e9, 1e9},
    {"lid",   revolute,   -1, {0.36, 0.48, 0.8}, {-0.1, 0.04,  0.05}, {0.28, 0.96, 0, 0},    -2.0, 2.0},
  }};
  static constexpr std::array<model::MarkerRow, 7> kMarkers{{
    {"corner",      ring,             -1, {-0.12, -0.09, 0.01}, {0, 0, -1},       0.05, 0.02},
    {"front",       dot_light_on_dark, -1, {0.11, -0.07, 0.02}, {0, 0.6, -0.8},   0.02, 0},
    {"flap_ring",   ring,              0, {0.05, 0.02, -0.03},  {0.48, 0.6, 0.64}, 0.04, 0.02},
    {"slider_ring", ring,              1, {0.02, 0.01, 0.03},   {0, 0, 1},        0.05, 0.02},
    {"slider_dot",  dot_dark_on_light, 1, {-0.04, 0.05, 0.02},  {1, 0, 0},        0.03, 0},
    {"wheel_ring",  ring,              2, {0.06, 0.02, -0.01},  {0.8, 0, 0.6},    0.05, 0.02},
    {"cover_ring",  ring,              3, {0.03, -0.06, 0.02},  {0, -0.8, -0.6},  0.05, 0.02},
  }};
  // clang-format on
  static constexpr bool kHasQ0 = false;
  static constexpr std::array<double, 11> kQ0{0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0};
};
static_assert(model::is_well_formed<Arm>());

/// The same arm with gears: the lid leads the hinge, whose row comes before its own, and the knob below it.
struct GearedArm : Arm {
  static constexpr auto kJoints = [] {
    auto rows = Arm::kJoints;
    rows[0].leader = 3, rows[0].ratio = -0.5, rows[0].offset = 0.2;
    rows[2].leader = 3, rows[2].ratio = 2;
    return rows;
  }();
  static constexpr std::array<double, 9> kQ0{0, 0, 0, 1, 0, 0, 0, 0, 0};
};
static_assert(model::is_well_formed<GearedArm>());

}  // namespace articam::test
