#pragma once
/// @file  All models of this folder, as a list of types and by name.

#include <array>
#include <string_view>
#include <utility>

#include "static_models/arm7/arm7.hpp"
#include "static_models/cabinet/cabinet.hpp"
#include "static_models/door/door.hpp"
#include "static_models/laptop/laptop.hpp"
#include "static_models/mire/mire.hpp"
#include "static_models/mire_distance/mire_distance.hpp"
#include "static_models/printer_drawer/printer_drawer.hpp"
#include "static_models/steering_wheel/steering_wheel.hpp"
#include "static_models/stress24/stress24.hpp"
#include "static_models/switch_panel/switch_panel.hpp"
#include "static_models/valve/valve.hpp"

namespace articam::models {

template <class... M>
struct TypeList {};

using StaticModels = TypeList<PrinterDrawer, Mire, MireDistance, Door, Valve, SteeringWheel, Cabinet, Laptop,
                              SwitchPanel, Arm7, Stress24>;

namespace detail {

template <class... M>
constexpr std::array<std::string_view, sizeof...(M)> names(TypeList<M...>) noexcept {
  return {M::kName...};
}

template <class Visitor, class... M>
constexpr bool visit(TypeList<M...>, std::string_view name, Visitor&& visitor) {
  return ((M::kName == name && (visitor.template operator()<M>(), true)) || ...);
}

}  // namespace detail

/// The names that programs take: kName, which is the robot's name in the URDF and the folder's name here.
inline constexpr auto kStaticModelNames = detail::names(StaticModels{});

/// Calls `visitor.operator()<Model>()` for the model of that name; false when there is none.
///
///     int exit_code = 2;
///     visit_model(name, [&]<class Model>() { exit_code = run<Model>(); });
template <class Visitor>
constexpr bool visit_model(std::string_view name, Visitor&& visitor) {
  return detail::visit(StaticModels{}, name, std::forward<Visitor>(visitor));
}

}  // namespace articam::models
