/// @file  One call of every iteration, for a profiler to count: `count_iterations.sh` does.

#include "tests/bench/iterations.hpp"

namespace {

using namespace articam;

template <class M, class S>
model::Configuration<M, S> truth() {
  return model::from_numbers<M, S>(M::kQ0).value();
}

}  // namespace

// Their names are what the counter is told to look for.
extern "C" {
[[gnu::noinline]] bool count_generic(const bench::Frame<models::PrinterDrawer, double>& frame) {
  return math::all_finite(bench::generic_iteration(frame).T_cam_obj.t);
}
[[gnu::noinline]] bool count_double(const bench::Frame<models::PrinterDrawer, double>& frame) {
  return math::all_finite(bench::iteration(frame).T_cam_obj.t);
}
[[gnu::noinline]] bool count_float(const bench::Frame<models::PrinterDrawer, float>& frame) {
  return math::all_finite(bench::iteration(frame).T_cam_obj.t);
}
[[gnu::noinline]] bool count_full_double(const bench::Frame<models::PrinterDrawer, double>& frame) {
  return math::all_finite(bench::iteration_full(frame).T_cam_obj.t);
}
[[gnu::noinline]] bool count_full_float(const bench::Frame<models::PrinterDrawer, float>& frame) {
  return math::all_finite(bench::iteration_full(frame).T_cam_obj.t);
}
[[gnu::noinline]] bool count_48(const bench::Frame<bench::Printer48, double>& frame) {
  return math::all_finite(bench::iteration(frame).T_cam_obj.t);
}
[[gnu::noinline]] bool count_24x48(const bench::Frame<bench::Chains24x48, double>& frame) {
  return math::all_finite(bench::iteration(frame).T_cam_obj.t);
}
[[gnu::noinline]] bool count_generic_24x48(const bench::Frame<bench::Chains24x48, double>& frame) {
  return math::all_finite(bench::generic_iteration(frame).T_cam_obj.t);
}
}

int main() {
  const bench::Frame<models::PrinterDrawer, double> printer{test::nominal_printer<models::PrinterDrawer, double>()};
  const bench::Frame<models::PrinterDrawer, float> printer_f{test::nominal_printer<models::PrinterDrawer, float>()};
  const bench::Frame<bench::Printer48, double> printer48{truth<bench::Printer48, double>()};
  const bench::Frame<bench::Chains24x48, double> chains{truth<bench::Chains24x48, double>()};
  const bool printers = count_generic(printer) && count_double(printer) && count_float(printer_f) &&
                        count_full_double(printer) && count_full_float(printer_f);
  return printers && count_48(printer48) && count_24x48(chains) && count_generic_24x48(chains) ? 0 : 1;
}
