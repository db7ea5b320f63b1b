#pragma once

#include <array>
#include <limits>
#include <vector>

#include "quadrille/detector/export.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/setting.hpp"

namespace quadrille {

/// How unobserved space is treated while the hand moves through it.
enum class UnknownPolicy {
  kWeighed,       ///< unknown space does not collide, but lowers the score of the grasp
  kObstacle,      ///< all unknown space collides
  kTargetShadow,  ///< unknown space behind the target itself is free, the rest collides
  kFree,          ///< unknown space never collides and costs nothing
};

constexpr auto words_of(UnknownPolicy) {
  return std::to_array<Word<UnknownPolicy>>({{"weighed", UnknownPolicy::kWeighed},
                                             {"obstacle", UnknownPolicy::kObstacle},
                                             {"target-shadow", UnknownPolicy::kTargetShadow},
                                             {"free", UnknownPolicy::kFree}});
}

/// Where the arm stands and how far it reaches, as settings; a Reach has the same values in frame
/// C.
struct ReachOptions {
  /// Farther than any arm reaches [m].
  static constexpr double kMaxReach = 100.0;
  /// Coordinates of a base may be as large as those of maps of the Earth [m].
  static constexpr double kMaxPlace = 1e7;

  std::vector<double> base = {0.0, 0.0, 0.0};
  double min = 0.0;
  double max = 0.0;

  /// Calls v(field, Setting) for each value.
  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.base,
      {"planner.reach.base", "m", -kMaxPlace, kMaxPlace,
       "Where the arm's base stands: three numbers, in the frame of the results. For the planner "
       "on the bus, in the fixed frame of the camera's poses if these come, else in the camera's "
       "frame."});
    v(o.min,
      {"planner.reach.min", "m", 0.0, kMaxReach,
       "Least distance between the base and the middle between the pads, at the grasp and at the "
       "start of the approach: nearer, the arm would be in its own way."});
    v(o.max, {"planner.reach.max", "m", 0.0, kMaxReach,
              "Greatest such distance, as far as the arm reaches. 0: any distance is good."});
  }
};

/// Options of the grasp planner.
struct PlanOptions {
  /// An hour, which is as good as no deadline [ms].
  static constexpr double kMaxDeadline = 3.6e6;

  UnknownPolicy unknown = UnknownPolicy::kWeighed;
  std::vector<QuadricType> targets;
  double resolution = 0.005;
  double friction = 0.5;
  double approach = 0.05;
  double pad_margin = 0.0025;
  double baseline = 0.09;
  double min_wall = 0.002;
  double max_wall = 0.008;
  bool clear_above = true;
  double min_score = 0.61;
  int per_target = 0;
  int max_grasps = 50;
  int max_detections = 256;
  double deadline_ms = 0.0;
  int threads = 1;
  ReachOptions reach;

  /// Calls v(field, Setting) for each option, in the order of the configuration file. The Setting
  /// describes the field.
  template <class Options, class Visitor>
  static void visit(Options& o, Visitor&& v) {
    v(o.unknown, {"planner.unknown",
                  "What unobserved space counts as while the hand moves through it: it lowers the "
                  "score; all of it collides; all but what lies behind the target itself; or it "
                  "costs nothing."});
    v(o.targets,
      {"planner.targets", "Grasp only these types; empty means all. The others stay in the way."});
    v(o.resolution, {"planner.resolution", "m", 0.0005, 0.1,
                     "Voxel edge of the occupancy map, and the size of the smallest things that it "
                     "is to show where the sensor measured nothing."});
    v(o.friction,
      {"planner.friction", "", 1e-6, 10.0, "Friction coefficient between pads and objects."});
    v(o.approach, {"planner.approach", "m", 0.0, 1.0, "Length of the straight approach to check."});
    v(o.pad_margin,
      {"planner.pad_margin", "m", 0.0, 0.1,
       "Least distance of each pad from the target on the way in: how unsure the hand's "
       "own way is. What is unsure of the target's size, 4 mm at most, adds to it in "
       "squares."});
    v(o.baseline, {"planner.baseline", "m", 0.0, 1.0,
                   "Distance between a depth sensor's two eyes, or eye and projector: the largest "
                   "whose blind bands beside the edges of things count as seen through, up to the "
                   "second eye's line of sight over the edge. 0: missing pixels tell nothing."});
    v(o.min_wall, {"planner.min_wall", "m", 0.0, 0.05,
                   "Least thickness of walls held at their rim, which one view does not show."});
    v(o.max_wall, {"planner.max_wall", "m", 0.0, 0.05, "Largest thickness of such walls."});
    v(o.clear_above, {"planner.clear_above",
                      "Whether space beside the image and at missing pixels counts as free where "
                      "it lies over space that was seen to be: what stands there would be seen "
                      "below. Not if things may hang down."});
    v(o.min_score,
      {"planner.min_score", "", 0.0, 1.0, "Least score of a grasp, its probability to succeed."});
    v(o.per_target,
      {"planner.per_target", "", 0, std::numeric_limits<int>::max(),
       "Grasps of each target at most, unlike in place and direction; the search goes on until "
       "there are so many. 0: all of an ordinary search, which ends with a dozen of a kind."});
    v(o.max_grasps,
      {"planner.max_grasps", "", 1, std::numeric_limits<int>::max(), "Grasps to return at most."});
    v(o.max_detections,
      {"planner.max_detections", "", 1, 4096,
       "Detections to plan on at most, those with the best score: the time that a plan takes grows "
       "with their number. The others are no targets, and only their points are in the way."});
    v(o.deadline_ms,
      {"planner.deadline_ms", "ms", 0.0, kMaxDeadline,
       "Time after which a plan ends with the grasps that it has, and says so. 0: none, so that "
       "the same input always gives the same plan. On the bus the planner has 500 ms if nothing "
       "else is set."});
    v(o.threads,
      {"planner.threads", "", 1, 256,
       "Threads that map space and search for grasps, each on another target; never changes the "
       "result. A query with a condition of the caller's own is answered by one."});
    ReachOptions::visit(o.reach, v);
  }

  /// @throws std::invalid_argument naming the field that is out of range
  QUADRILLE_EXPORT void check() const;
};

}  // namespace quadrille
