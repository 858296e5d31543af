#pragma once
/// @file  Normal equations of many moments that share constants: blocks along the diagonal and one border, an arrow.

#include <Eigen/Core>

#include <vector>

namespace articam::identify {

/// H and the pull -g of  H step = pull  for one moment: its own unknowns, and what they have in common with the shared
/// ones.
struct MomentBlock {
  Eigen::MatrixXd own;    ///< m x m
  Eigen::MatrixXd cross;  ///< m x shared
  Eigen::VectorXd pull;   ///< m
};

struct ArrowStep {
  std::vector<Eigen::VectorXd> own;
  Eigen::VectorXd shared;
};

struct Arrow {
  std::vector<MomentBlock> moments;
  Eigen::MatrixXd shared;
  Eigen::VectorXd pull;

  /// Its solution, every diagonal number raised by a share of itself (Marquardt).
  ArrowStep solve(double damping) const;

  /// The information about the shared unknowns when all others are unknown: Schur's complement.
  Eigen::MatrixXd reduced() const;
};

/// The information about the unknowns before `first` when those from there on are unknown, too.
Eigen::MatrixXd marginal(const Eigen::MatrixXd& information, Eigen::Index first);

}  // namespace articam::identify
