#pragma once
/// @file  What no recording tells of markers' places, and what is taken instead.
///
/// A rigid displacement of all markers looks like another base pose, one of a joint's markers along it like another
/// zero of the joint. Such directions are found by asking the information itself (a joint that moves tells how the base
/// lies to its axis), and held so that as many markers as possible stay where the model has them: least sum of
/// distances, then no mean displacement of those that did not move.
///
/// Source  Chen, "Analysis of deformation surveys", UNB Technical Report 94, 1983 (iterative weighted similarity
///         transformation); Baarda's S-transformation for the covariance.

#include "tools/identify/constants.hpp"

namespace articam::identify {

struct Datum {
  MatrixXd held;                ///< a column for each direction that is held: constants x directions
  std::vector<bool> reference;  ///< of each marker: it is seen, and helps to hold the frame
  MatrixXd covariance;          ///< of the constants, with these directions held
  VectorXd shift;               ///< along them: constants + shift meet the rule
};

/// The constants of a solution with what else that needs.
struct Free {
  VectorXd constants;
  MatrixXd information;    ///< about them, prior included
  VectorXd values;         ///< joint values somewhere in the recording
  std::vector<bool> seen;  ///< of each marker: at least once
};

/// Without places among the constants nothing is held.
Datum hold_datum(const Object& object, const Constants& constants, const Free& solution);

}  // namespace articam::identify
