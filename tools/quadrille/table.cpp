#include "quadrille/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/describe.hpp"
#include "io/planner/advice.hpp"

namespace quadrille {
namespace {

/// Says why a target has no grasp, and what would give it one, if that was tried.
std::string lines_of(const TargetOutcome& outcome, const GraspPlan& plan, bool advised) {
  std::string text =
      fmt::format("  no grasp on {}: {}\n", outcome.target, explain_no_grasp(outcome));
  if (!advised) return text;
  std::string tried;
  for (const Remedy& remedy : plan.remedies) {
    if (remedy.target != outcome.target) continue;
    tried += fmt::format("    {}: {} grasp{}, the best with a score of {:.2f}\n", remedy.change,
                         remedy.grasps, remedy.grasps == 1 ? "" : "s", remedy.score);
  }
  return text + (tried.empty() ? "    no other hand or setting that was tried gives one\n" : tried);
}

}  // namespace

std::string detection_table(const io::InputInfo& input, const DetectionResult& result,
                            const Paint& paint) {
  std::string text = fmt::format(
      "{}: {} points, {} finite, {} used; read {:.1f} ms, detect {:.1f} ms\n", input.input,
      input.points_read, result.points_finite, result.points_used, input.read_ms, result.total_ms);
  const bool nothing = result.detections.empty() && result.boxes.empty() && result.bodies.empty();
  if (nothing) return text + paint.bad("  no quadrics found") + "\n";
  const auto has_track = [](const auto& thing) { return thing.track > 0; };
  const bool tracked = std::any_of(result.detections.begin(), result.detections.end(), has_track) ||
                       std::any_of(result.bodies.begin(), result.bodies.end(), has_track);
  // The cell of a box or lump, whose track is that of its body.
  const auto track_of_body = [&](int id) {
    const auto body = std::find_if(result.bodies.begin(), result.bodies.end(),
                                   [id](const SceneBody& b) { return b.id == id; });
    if (!tracked) return std::string();
    return body == result.bodies.end() ? std::string(7, ' ') : fmt::format("{:>5}  ", body->track);
  };
  text += paint.head(fmt::format("  {:>3}  {}{:<22} {:>5} {:>8} {:>7} {:>5}  {:^23}  {}", "id",
                                 tracked ? "track  " : "", "type", "score", "inliers", "rms/mm",
                                 "seen", "position/m", "dimensions")) +
          "\n";
  for (const Detection& d : result.detections) {
    const Eigen::Vector3d p = d.X_CQ.translation();
    const std::string row = fmt::format(
        "  {:>3}  {}{:<22} {:>5.2f} {:>8} {:>7.2f} {:>5.2f}  {:>7.3f} {:>7.3f} {:>7.3f}  {}", d.id,
        tracked ? fmt::format("{:>5}  ", d.track) : "", to_string(d.type), d.score, d.inliers,
        1000.0 * d.rms, d.seen, p.x(), p.y(), p.z(), io::describe_dimensions(d));
    text += (is_flat(d.type) ? paint.faint(row) : row) + "\n";
  }
  for (const Box& box : result.boxes) {
    const Eigen::Vector3d p = box.X_CB.translation();
    text += fmt::format("  {:>3}  {}{:<22} {:>5.2f} {:>22}  {:>7.3f} {:>7.3f} {:>7.3f}  {}\n",
                        box.id, track_of_body(box.id), "box", box.score, "", p.x(), p.y(), p.z(),
                        io::describe_box(box));
  }
  for (const SceneBody& body : result.bodies) {
    // Without tracks and a wall a round body says no more than its main part.
    if (body.kind == BodyKind::kRevolution && (tracked || body.wall)) {
      text += fmt::format("  {:>3}  {}body of {}{}\n", body.id, track_of_body(body.id),
                          fmt::join(body.parts, ", "),
                          body.wall ? ", " + io::describe_wall(*body.wall) : "");
    }
    if (body.kind != BodyKind::kLump) continue;
    const Eigen::Vector3d p = body.X_CB.translation();
    text += fmt::format("  {:>3}  {}{:<28} {:>8} {:>13}  {:>7.3f} {:>7.3f} {:>7.3f}  {}\n", body.id,
                        track_of_body(body.id), "lump", body.points, "", p.x(), p.y(), p.z(),
                        io::describe_lump(body));
  }
  return text;
}

std::string grasp_table(const GraspPlan& plan, bool advised, const Paint& paint) {
  std::string text;
  if (plan.grasps.empty()) {
    text = paint.bad("  no grasps found") + "\n";
    if (plan.targets.empty()) {
      text += "  nothing that could be grasped was found, or asked for";
      text += plan.warnings.empty() ? "\n" : "; see the warnings\n";
    }
  } else {
    text = paint.head(fmt::format("  {:>5} {:>6} {:<6} {:>5} {:>8} {:>8} {:>8} {:>7}        {}",
                                  "grasp", "target", "kind", "score", "width/mm", "friction",
                                  "epsilon", "free/mm", "position/m")) +
           "\n";
  }
  int number = 0;
  for (const Grasp& g : plan.grasps) {
    const Eigen::Vector3d p = g.X_CG.translation();
    text += fmt::format(
        "  {:>5} {:>6} {:<6} {:>5.2f} {:>8.1f} {:>8.2f} {:>8.3f} {:>7.1f}  {:>7.3f} {:>7.3f} "
        "{:>7.3f}{}\n",
        ++number, g.target, to_string(g.kind), g.score, 1000.0 * g.width, g.friction_needed,
        g.epsilon, 1000.0 * g.clearance, p.x(), p.y(), p.z(),
        g.unknown_contact ? "  touches an unseen part" : "");
  }
  std::map<int, std::string> without;
  for (const TargetOutcome& outcome : plan.targets) {
    if (outcome.grasps == 0) without[outcome.target] = lines_of(outcome, plan, advised);
  }
  for (const auto& [target, lines] : without) text += lines;
  if (!without.empty() && !advised) {
    text += "  --advise tries other settings and hands for these, and proposes views\n";
  }
  if (plan.rejected.empty()) return text;
  std::string reasons;
  for (const auto& [reason, count] : plan.rejected) {
    reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", reason, count);
  }
  return text + paint.faint(fmt::format("  refused: {}; plan {:.1f} ms", reasons, plan.total_ms)) +
         "\n";
}

std::string look_table(const std::vector<Look>& looks) {
  std::string text;
  for (const Look& look : looks) {
    const double of_ten = std::round(10.0 * look.gain / static_cast<double>(look.bodies.size()));
    const Eigen::Vector3d p = look.X_CK.translation(), ahead = look.X_CK.linear().col(2);
    text += fmt::format(
        "  a view from {:.3f} {:.3f} {:.3f} along {:.2f} {:.2f} {:.2f} may help {}; it gives about "
        "{:.0f} in 10 such bodies a better grasp\n",
        p.x(), p.y(), p.z(), ahead.x(), ahead.y(), ahead.z(), fmt::join(look.bodies, ", "), of_ten);
  }
  return text;
}

}  // namespace quadrille
