/// @file  Writes the first frames of the drawn recording as PGM files: draw_frames FOLDER NUMBER

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/bits/scene.hpp"

int main(int argc, char** argv) {
  using articam::test::Scene;
  if (argc != 3) return std::fputs("usage: draw_frames FOLDER NUMBER\n", stderr), 2;
  std::filesystem::create_directories(argv[1]);
  std::vector<std::uint8_t> pixels(Scene::kPixels);
  for (unsigned k = 0; k < std::strtoul(argv[2], nullptr, 10); ++k) {
    Scene::draw(k, std::span<std::uint8_t, Scene::kPixels>{pixels});
    std::string number = std::to_string(k);
    number.insert(0, 6 - number.size(), '0');
    std::ofstream file{std::filesystem::path{argv[1]} / ("frame_" + number + ".pgm"), std::ios::binary};
    file << "P5\n" << Scene::kWidth_px << ' ' << Scene::kHeight_px << "\n255\n";
    if (!file.write(reinterpret_cast<const char*>(pixels.data()), Scene::kPixels)) return 1;
  }
  return 0;
}
