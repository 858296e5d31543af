// One wrong use for each value of WRONG_USE; without one the file must compile. See the CMakeLists.txt above.
#include <array>
#include <chrono>
#include <string>
#include <string_view>

#include "core/fixed_vector.hpp"
#include "core/model/model_table.hpp"
#include "core/status.hpp"
#include "core/timestamp.hpp"
#include "hal/ports/camera_port.hpp"

#ifndef WRONG_USE
#define WRONG_USE 0
#endif

namespace articam {

Status do_work() noexcept;
Result<int> measure() noexcept;

#if WRONG_USE == 1
Result<std::string> result_that_owns_memory() { return std::string{"text"}; }
#elif WRONG_USE == 2
FixedVector<std::string, 3> list_that_owns_memory;
#elif WRONG_USE == 3
void ignores_a_status() { do_work(); }
#elif WRONG_USE == 4
void ignores_a_result() { measure(); }
#elif WRONG_USE == 5
void ignores_that_a_list_is_full(FixedVector<int, 3>& list) { list.push_back(1); }
#elif WRONG_USE == 6
auto adds_seconds_to_a_timestamp(Timestamp t) { return t + 0.5; }
#endif

/// Two joints in a chain; the first names its parent.
template <int FirstParent>
struct Chain {
  static constexpr std::string_view kName = "chain";
  static constexpr std::array<model::JointRow, 2> kJoints{{
      {"a", model::JointKind::revolute, FirstParent, {0, 0, 1}, {0, 0, 0}, {1, 0, 0, 0}, -1, 1},
      {"b", model::JointKind::revolute, 0, {0, 0, 1}, {0, 0, 0}, {1, 0, 0, 0}, -1, 1},
  }};
  static constexpr std::array<model::MarkerRow, 0> kMarkers{};
  static constexpr bool kHasQ0 = false;
  static constexpr std::array<double, 9> kQ0{};
};
static_assert(model::is_well_formed<Chain<WRONG_USE == 7 ? 1 : -1>>(), "parents come before their children");

/// Calls that throw have no place in the loop.
struct Camera {
  Status start() noexcept;
  void stop() noexcept;
  Status acquire(hal::Frame& out, std::chrono::milliseconds wait) noexcept(WRONG_USE != 8);
  void release(hal::Frame& frame) noexcept;
};
static_assert(hal::CameraPort<Camera>, "not a camera port");

}  // namespace articam
