#pragma once
/// @file  Rows of "what | target | got | met", and what an item of the table is given.

#include <fmt/core.h>

#include <cstdint>
#include <string>

namespace articam::estimator_table {

/// A markdown table, printed row by row; what misses its target is bold.
class Table {
 public:
  explicit Table(const char* title) {
    fmt::print("\n**{}**\n\n| what | target | got | met |\n|---|---|---|---|\n", title);
  }

  void row(const std::string& what, const std::string& target, const std::string& got, bool met) {
    fmt::print("| {} | {} | {} | {} |\n", what, target, met ? got : "**" + got + "**", met ? "yes" : "no");
    ++rows_, met_ += met ? 1 : 0;
    std::fflush(stdout);
  }
  /// Where nothing is asked for.
  void tell(const std::string& what, const std::string& got) {
    fmt::print("| {} | | {} | |\n", what, got);
    std::fflush(stdout);
  }
  int rows() const { return rows_; }
  int met() const { return met_; }

 private:
  int rows_{}, met_{};
};

struct Run {
  int trials;  ///< of `crb`, 20,000 in full; the other items take their part of it
  std::uint64_t seed;

  /// As many as an item has in full, brought down with `trials`; at least one.
  int part(int in_full) const {
    const auto n = static_cast<int>(static_cast<std::int64_t>(in_full) * trials / 20000);
    return n > 0 ? n : 1;
  }
  void progress(const std::string& what) const { fmt::print(stderr, "  {}\n", what); }
};

/// Each measures one line of the targets.
void crb(const Run& run, Table& table);
void nees(const Run& run, Table& table);
void outliers(const Run& run, Table& table);
void convergence(const Run& run, Table& table);
void hidden(const Run& run, Table& table);
void flips(const Run& run, Table& table);
void moving(const Run& run, Table& table);
void shape(const Run& run, Table& table);

}  // namespace articam::estimator_table
