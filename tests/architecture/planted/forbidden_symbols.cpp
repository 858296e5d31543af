// Breaks every rule that forbidden_symbols.cmake guards. Never linked.
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace articam::planted {

void* from_the_heap() { return std::malloc(10); }
int* from_operator_new() { return new int{1}; }
void back_to_the_heap(int* number) { delete number; }
[[noreturn]] void throws() { throw std::runtime_error{"planted"}; }
int checked(const std::vector<int>& numbers) { return numbers.at(3); }
double from_libm(double x) { return std::sin(x); }
const std::string& guarded() {
  static const std::string text(100, 'a');
  return text;
}

}  // namespace articam::planted
