#include "tools/identify/arrow.hpp"

#include <Eigen/Cholesky>

#include <utility>

namespace articam::identify {
namespace {

/// What a moment's unknown is known to without any mark: a metre, a radian. Enough to factorise, far from any estimate.
constexpr double kBarely = 1;

Eigen::LDLT<Eigen::MatrixXd> factor(const MomentBlock& block, double damping) {
  Eigen::MatrixXd own = block.own;
  own.diagonal() *= 1 + damping;
  own.diagonal().array() += kBarely;
  return own.ldlt();
}

}  // namespace

ArrowStep Arrow::solve(double damping) const {
  Eigen::MatrixXd border = shared;
  border.diagonal() *= 1 + damping;
  Eigen::VectorXd right = pull;
  std::vector<std::pair<Eigen::MatrixXd, Eigen::VectorXd>> solved;  // own^-1 cross, own^-1 pull
  for (const MomentBlock& block : moments) {
    const auto own = factor(block, damping);
    solved.emplace_back(own.solve(block.cross), own.solve(block.pull));
    border -= block.cross.transpose() * solved.back().first;
    right -= block.cross.transpose() * solved.back().second;
  }
  ArrowStep step{{}, border.ldlt().solve(right)};
  for (const auto& [by_shared, alone] : solved) step.own.push_back(alone - by_shared * step.shared);
  return step;
}

Eigen::MatrixXd Arrow::reduced() const {
  Eigen::MatrixXd border = shared;
  for (const MomentBlock& block : moments) border -= block.cross.transpose() * factor(block, 0).solve(block.cross);
  return border;
}

Eigen::MatrixXd marginal(const Eigen::MatrixXd& information, Eigen::Index first) {
  const Eigen::Index rest = information.rows() - first;
  return information.topLeftCorner(first, first) -
         information.topRightCorner(first, rest) *
             information.bottomRightCorner(rest, rest).ldlt().solve(information.bottomLeftCorner(rest, first));
}

}  // namespace articam::identify
