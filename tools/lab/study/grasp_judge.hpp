#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/physics/true_scene.hpp"
#include "lab/study/surface_points.hpp"
#include "quadrille/grasping/grasp.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille::study {

/// The verdict of the true geometry on a grasp; the first that applies counts.
enum class Verdict {
  kTouches,  ///< the hand, on its way in, enters an object or the table by more than 2 mm
  kMisses,   ///< between the pads is nothing, or more than one object
  kSlips,    ///< the surface there is inclined too steeply for the friction
  kGood,     ///< none of these
};

/// Returns "touches", "misses", "slips" or "good".
std::string to_string(Verdict verdict);

/// A verdict and the object between the pads.
struct Judgement {
  Verdict verdict = Verdict::kMisses;
  /// The object, or nullptr if there is none.
  const physics::TrueBody* object = nullptr;
};

/// Judges grasps by the full true geometry of a scene, visible and hidden alike, without physics.
class GraspJudge {
 public:
  /// @param scene     must outlive the judge
  /// @param friction  coefficient between pads and objects
  GraspJudge(const physics::TrueScene& scene, const Gripper& gripper, double friction);

  Judgement judge(const Grasp& grasp) const;

 private:
  /// The points of the scene that lie between the pads, in frame G.
  struct Between {
    std::vector<Eigen::Vector3d> p_G, n_G;
    const physics::TrueBody* object = nullptr;
    /// Share of the points that lie on the object.
    double share = 0.0;
  };

  Between between_pads(const Grasp& grasp) const;
  bool touches(const Grasp& grasp) const;
  bool is_below_table(const Grasp& grasp) const;
  bool slips(const Between& between) const;

  const physics::TrueScene& scene_;
  Gripper gripper_;
  double friction_;
  std::vector<SurfacePoints> points_;
};

}  // namespace quadrille::study
