#pragma once

#include "quadrille/grasping/grasp_query.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The options that select grasps, in the frame of the results.
class QueryArguments {
 public:
  /// Adds --target, --near, --roi, --min-size, --max-size, --min-clearance, --approach and --best;
  /// this object must outlive the app.
  void add_to(CLI::App& app);
  /// Returns the query.
  /// @throws CLI::ValidationError if the options contradict each other
  GraspQuery query() const;

 private:
  GraspQuery query_;
};

}  // namespace quadrille
