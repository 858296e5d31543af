// What firmware code may need of its surroundings.
#include <cmath>
#include <cstring>

namespace articam::planted {

double root(double x) { return std::sqrt(x); }
void copy(void* to, const void* from, std::size_t size) { std::memcpy(to, from, size); }

}  // namespace articam::planted
