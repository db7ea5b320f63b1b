#include "process/planner/status_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/hash.hpp"
#include "io/json/shapes_file.hpp"
#include "io/planner/gripper_file.hpp"
#include "io/planner/octree_file.hpp"
#include "io/planner/plan_json.hpp"
#include "process/runtime/status/exposition.hpp"
#include "process/runtime/status/process_info.hpp"

namespace quadrille {

std::string hash_of(const PlannerSettings& settings) {
  SettingsText text;
  text.add_all(settings.plan);
  text.add("gripper", io::to_toml(settings.gripper));
  if (settings.approach) {
    const Eigen::Vector3d& axis = settings.approach->axis_C;
    text.add("approach", fmt::format("{},{},{},{}", axis.x(), axis.y(), axis.z(),
                                     settings.approach->half_angle));
  }
  for (const CollisionShape& shape : settings.obstacles) {
    text.add("obstacle", io::to_json(shape).dump());
  }
  for (const CollisionShape& shape : settings.attached) {
    text.add("attached", io::to_json(shape).dump());
  }
  for (const double number : {settings.detector.views.remember, settings.detector.views.sector,
                              static_cast<double>(settings.detector.views.most),
                              settings.detector.views.shift, settings.detector.views.turn}) {
    text.add("views", io::toml_of(number));
  }
  text.add("padding", io::toml_of(settings.known.robot.padding));
  for (const SolidShape& shape : settings.known.robot.shapes) {
    text.add("robot", io::to_json(shape).dump());
  }
  if (const auto& support = settings.known.support) {
    const Eigen::Vector3d& n = support->n_C;
    text.add("support", fmt::format("{},{},{},{}", n.x(), n.y(), n.z(), support->offset));
  }
  if (settings.known.map.tree) {
    text.add("octomap", io::hash_text(io::octree_bytes(*settings.known.map.tree)));
  }
  text.add("on_request", settings.on_request ? "true" : "false");
  text.add("pose_age", io::toml_of(settings.pose_age));
  text.add("pose_wait", io::toml_of(settings.pose_wait));
  text.add_channels(channels_of(settings));
  text.add_frames(settings.frames, settings.X_WK);
  for (const ViewCamera& camera : settings.view_cameras) {
    text.add_frames(settings.frames, camera.X_WK);
  }
  return text.hash();
}

std::string to_exposition(const planner_status_t& status, const PlannerSettings& settings) {
  Exposition out("quadrille_planner", {{"channel", settings.cloud_channel},
                                       {"status_channel", settings.status_channel}});
  out.add_counter("clouds_received", "Messages on the channel of the clouds.",
                  status.received_clouds);
  out.add_counter("clouds_decoded", "Clouds that passed all checks.", status.decoded_clouds);
  out.add_counter("clouds_missing", "Clouds that never came, by gaps in their seq.",
                  status.missing_clouds);
  out.add_counter("quadrics_received", "Messages on the channel of the quadrics.",
                  status.received_quadrics);
  out.add_counter("quadrics_decoded", "Quadrics that passed all checks.", status.decoded_quadrics);
  out.add_counter("quadrics_unpaired", "Quadrics whose cloud never came.",
                  status.unpaired_quadrics);
  out.add_counters("quadrics_without_cloud", "The same, by reason.", status.unpaired);
  out.add_counter("pairs", "Clouds with their quadrics.", status.paired);
  out.add_counter("pairs_superseded",
                  "Pairs, and clouds of further cameras, dropped for a newer one.",
                  status.superseded);
  out.add_counter("pairs_failed", "Pairs, and clouds of further cameras, on which the work failed.",
                  status.failed);
  out.add_counter("grasps_published", "Messages of grasps.", status.published);
  out.add_views(status);
  out.add_counter("plans_cut", "Plans that their deadline cut short.", status.cut);
  out.add_counter("requests_received", "Requests for grasps.", status.requests);
  out.add_counter("requests_answered", "Requests that were answered.", status.answered);
  out.add_counter("requests_unmet", "Requests that could not be met.", status.unmet);
  out.add_counters("clouds_refused", "Clouds refused.", status.rejected_clouds);
  out.add_counters("quadrics_refused", "Quadrics refused.", status.rejected_quadrics);
  out.add_counters("requests_refused", "Requests refused.", status.rejected_requests);
  out.add_counters("poses_refused", "Poses refused.", status.rejected_poses);
  out.add_counters("knowledge_refused", "Messages on the robot and its surroundings refused.",
                   status.rejected_knowledge);
  out.add_counters("clouds_unplaced", "Clouds without the camera's pose.", status.unplaced);
  out.add_pose_age(status.pose_age);
  out.add_gauge("clouds_per_second", "Over the last ten seconds.", status.received_rate);
  out.add_gauge("grasps_per_second", "Over the last ten seconds.", status.published_rate);
  out.add_common(status);
  return out.text();
}

}  // namespace quadrille
