#pragma once

#include <optional>
#include <string>
#include <vector>

#include "quadrille/grasping/grasp_query.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// Adds --approach, which sets a cone of directions; the cone must outlive the app.
/// @param frame  the frame of the directions, for the description
void add_approach_option(CLI::App& app, std::optional<Cone>& cone, const std::string& frame);

/// Adds --obstacles, a file that is read into shapes; they must outlive the app.
/// @param frame  the frame of the shapes, for the description
void add_obstacles_option(CLI::App& app, std::vector<CollisionShape>& obstacles,
                          const std::string& frame);

/// Adds --attached, a file that is read into shapes in the hand's frame G; they must outlive the
/// app.
void add_attached_option(CLI::App& app, std::vector<CollisionShape>& attached);

/// The options that select grasps, in the frame of the results.
class QueryArguments {
 public:
  /// Adds --target, --near, --roi, --min-size, --max-size, --min-clearance, --approach,
  /// --obstacles, --attached and --best; this object must outlive the app.
  void add_to(CLI::App& app);
  /// Returns the query.
  /// @throws CLI::ValidationError if the options contradict each other
  GraspQuery query() const;

 private:
  GraspQuery query_;
};

}  // namespace quadrille
