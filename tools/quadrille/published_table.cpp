#include "quadrille/published_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "io/describe.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/detector/setting.hpp"
#include "quadrille/grasping/grasp.hpp"

namespace quadrille {

namespace {

std::int64_t total_of(const std::vector<count_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0},
                         [](std::int64_t sum, const count_t& c) { return sum + c.count; });
}

std::string warning_lines(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings)
    text += "      " + printable(warning, kMaxLine) + "\n";
  return text;
}

}  // namespace

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
  return text + warning_lines(message.warnings);
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

std::string published_table(const std::string& channel, const bus::BodiesMessage& message) {
  std::string text = fmt::format("{}: cloud {} us, frame '{}', bodies: {}\n", printable(channel),
                                 message.utime, printable(message.frame), message.bodies.size());
  for (const SceneBody& body : message.bodies) {
    const Eigen::Vector3d p = body.X_CB.translation();
    text += fmt::format("{:>4}  {:<22} {:>6} points  at [m] {:>7.3f} {:>7.3f} {:>7.3f}  {}\n",
                        body.id, to_string(body.kind), body.points, p.x(), p.y(), p.z(),
                        io::describe_body(body));
  }
  return text;
}

std::string published_table(const std::string& channel, const bus::BodyTracksMessage& message) {
  std::string text =
      fmt::format("{}: cloud {} us, frame '{}', tracks of bodies: {}\n", printable(channel),
                  message.utime, printable(message.frame), message.track_of.size());
  for (const auto& [id, track] : message.track_of) {
    text += fmt::format("{:>4}  track {}\n", id, track);
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
        i + 1, to_string(static_cast<GraspKind>(g.kind)), g.target, g.score, g.pose.position[0],
        g.pose.position[1], g.pose.position[2], 1000.0 * g.width, 1000.0 * g.clearance);
  }
  text += warning_lines(message.warnings);
  for (const target_outcome_t& target : message.targets) {
    if (target.num_grasps > 0) continue;
    text += fmt::format(
        "      no grasp on {}: {}\n", target.target,
        target.furthest.empty() ? "no way to hold it was found" : printable(target.furthest));
  }
  return text;
}

std::string published_table(const std::string& channel, const detector_status_t& status) {
  return fmt::format(
             "{}: detector at {} us: received {} ({:.1f} Hz), published {}, missing {}, superseded "
             "{}, refused {}, failed {}, without a pose {}\n",
             printable(channel), status.utime, status.received, status.received_rate,
             status.published, status.missing, status.superseded, total_of(status.rejected),
             status.failed, total_of(status.untracked)) +
         warning_lines(status.warnings);
}

std::string published_table(const std::string& channel, const planner_status_t& status) {
  return fmt::format(
             "{}: planner at {} us: received {} clouds ({:.1f} Hz) and {} quadrics, published {}, "
             "missing {}, without their cloud {}, superseded {}, refused {}, failed {}, without a "
             "pose {}\n",
             printable(channel), status.utime, status.received_clouds, status.received_rate,
             status.received_quadrics, status.published, status.missing_clouds,
             status.unpaired_quadrics, status.superseded,
             total_of(status.rejected_clouds) + total_of(status.rejected_quadrics), status.failed,
             total_of(status.unplaced)) +
         warning_lines(status.warnings);
}

}  // namespace quadrille
