#pragma once

#include "quadrille/grasping/grasp_query.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The options that say which grasps are wanted, in the frame of the results.
struct QueryArguments {
  GraspQuery query;

  /// Adds --target, --near, --roi, --min-size, --max-size, --min-clearance, --approach and --best;
  /// this must outlive the app.
  void add_to(CLI::App& app);
};

}  // namespace quadrille
