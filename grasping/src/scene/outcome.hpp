#pragma once

#include <vector>

#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/refusal.hpp"

namespace quadrille {

/// The grasps that were found on one target, or on all parts of a body, and the candidates that
/// were refused.
struct Outcome {
  std::vector<Grasp> grasps;
  RefusalCounts refusals;
  /// Number of candidates that were too unlikely to succeed to be tried.
  int unlikely = 0;
  /// True if the deadline ended the search early.
  bool cut = false;
};

/// Joins the outcomes of the parts of one body, the grasps with the best score first. Of grasps
/// that are nearly the same, such as those at the rim of a cup that were found on its outer and on
/// its inner side, only the best one stays. One outcome alone stays as it is.
Outcome joined(std::vector<Outcome> parts);

/// Returns the refusals. Candidates that were too unlikely to be tried count only if there is no
/// grasp and nothing stood in the way of likelier ones, since that would tell more.
RefusalCounts told_refusals(const Outcome& found);

}  // namespace quadrille
