#include "quadrille/published_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/describe.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/detector/setting.hpp"
#include "quadrille/grasping/grasp.hpp"

namespace quadrille {

std::string published_table(const std::string& channel, const bus::QuadricsMessage& message) {
  std::string text =
      fmt::format("{}: cloud {} us, frame '{}', quadrics: {}\n", printable(channel), message.utime,
                  printable(message.frame), message.detections.size());
  for (const Detection& d : message.detections) {
    const Eigen::Vector3d p = d.X_CQ.translation();
    text +=
        fmt::format("{:>4}  {:<22} score {:.2f}  at [m] {:>7.3f} {:>7.3f} {:>7.3f}  {}\n", d.id,
                    to_string(d.type), d.score, p.x(), p.y(), p.z(), io::describe_dimensions(d));
  }
  return text;
}

std::string published_table(const std::string& channel, const bus::BoxesMessage& message) {
  std::string text = fmt::format("{}: cloud {} us, frame '{}', boxes: {}\n", printable(channel),
                                 message.utime, printable(message.frame), message.boxes.size());
  for (const Box& box : message.boxes) {
    const Eigen::Vector3d p = box.X_CB.translation();
    text += fmt::format("{:>4}  {:<22} score {:.2f}  at [m] {:>7.3f} {:>7.3f} {:>7.3f}  {}\n",
                        box.id, "box", box.score, p.x(), p.y(), p.z(), io::describe_box(box));
  }
  return text;
}

std::string published_table(const std::string& channel, const grasps_t& message,
                            std::size_t max_grasps) {
  const std::string asked =
      message.request_id == 0 ? "" : fmt::format(", answer to request {}", message.request_id);
  std::string text =
      fmt::format("{}: cloud {} us{}, hand {}, grasps: {}\n", printable(channel), message.utime,
                  asked, printable(message.gripper), message.grasps.size());
  for (std::size_t i = 0; i < std::min(message.grasps.size(), max_grasps); ++i) {
    const grasp_t& g = message.grasps[i];
    text += fmt::format(
        "  {:>4}  {:<6} on {}  score {:.2f}  at [m] {:>7.3f} {:>7.3f} {:>7.3f}"
        "  width {:.0f} mm  clearance {:.0f} mm\n",
        i + 1, word_of(static_cast<GraspKind>(g.kind)), g.target, g.score, g.pose.position[0],
        g.pose.position[1], g.pose.position[2], 1000.0 * g.width, 1000.0 * g.clearance);
  }
  for (const std::string& warning : message.warnings)
    text += "      " + printable(warning, kMaxLine) + "\n";
  for (const target_outcome_t& target : message.targets) {
    if (target.num_grasps > 0) continue;
    text += fmt::format(
        "      no grasp on {}: {}\n", target.target,
        target.furthest.empty() ? "no way to hold it was found" : printable(target.furthest));
  }
  return text;
}

}  // namespace quadrille
