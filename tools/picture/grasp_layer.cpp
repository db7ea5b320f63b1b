#include "picture/grasp_layer.hpp"

#include <algorithm>
#include <map>

namespace quadrille {
namespace {

constexpr int kThinPerTarget = 3;
const Color kInk(0.05f, 0.05f, 0.05f), kBest(0.25f, 1.0f, 0.3f), kOther(0.75f, 0.95f, 0.75f);

struct Stroke {
  double width;
  Color color;
  float alpha;
};

void draw_hand(const Grasp& grasp, const Gripper& gripper, const View& view, const Stroke& stroke,
               Image* image) {
  const double half = std::max(grasp.preshape, grasp.width) / 2, tip = gripper.finger_front;
  const double back = -gripper.reach(grasp.width), wrist = back - gripper.palm.z();
  const double start = wrist - std::min(grasp.approach, 0.1);
  const auto line = [&](const Eigen::Vector3d& from_G, const Eigen::Vector3d& to_G) {
    const auto from = view.project(grasp.X_CG * from_G), to = view.project(grasp.X_CG * to_G);
    if (from && to) draw_line(*from, *to, stroke.width, stroke.color, stroke.alpha, image);
  };
  line({0, -half, tip}, {0, -half, back});
  line({0, half, tip}, {0, half, back});
  line({0, -half, back}, {0, half, back});
  line({0, 0, back}, {0, 0, start});
}

}  // namespace

void draw_grasps(const GraspPlan& plan, const Gripper& gripper, const View& view, Image* image) {
  std::map<int, int> drawn;
  std::vector<const Grasp*> best;
  for (const Grasp& grasp : plan.grasps) {
    const int rank = drawn[grasp.target]++;
    if (rank == 0) best.push_back(&grasp);
    if (rank == 0 || rank > kThinPerTarget) continue;
    draw_hand(grasp, gripper, view, {1.5, kOther, 0.6f}, image);
  }
  // The best hands last, so that they lie on top.
  std::reverse(best.begin(), best.end());
  for (const Grasp* grasp : best) {
    draw_hand(*grasp, gripper, view, {8.0, kInk, 0.8f}, image);
    draw_hand(*grasp, gripper, view, {4.5, kBest, 1.0f}, image);
    for (const Eigen::Vector3d& contact : grasp->contacts_C) {
      const auto at = view.project(contact);
      if (!at) continue;
      draw_disc(*at, 6.0, kInk, image);
      draw_disc(*at, 4.0, Color(1.0f, 0.25f, 0.2f), image);
    }
  }
}

}  // namespace quadrille
