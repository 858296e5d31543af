#pragma once
/// @file  A folder that only the running test uses: tests run beside each other.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace articam::test {

/// In the system's temporary folder, named after the test; nothing is created.
inline std::filesystem::path own_folder() {
  const auto& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string("articam.") + test.test_suite_name() + '.' + test.name();
  for (char& c : name) c = c == '/' ? '_' : c;
  return std::filesystem::path(testing::TempDir()) / name;
}

}  // namespace articam::test
