#pragma once

#include "quadrille/grasping/grasp_query.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The options that say which grasps are wanted, in the frame of the results.
class QueryArguments {
 public:
  /// Adds --target, --near, --roi, --min-size, --max-size, --min-clearance, --approach and --best;
  /// this must outlive the app.
  void add_to(CLI::App& app);
  /// What is asked for.
  /// @throws CLI::ValidationError if the options contradict each other
  GraspQuery query() const;

 private:
  GraspQuery query_;
};

}  // namespace quadrille
