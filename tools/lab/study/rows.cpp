#include "lab/study/rows.hpp"

#include <fmt/format.h>

#include "io/hash.hpp"
#include "lab/study/csv.hpp"
#include "quadrille/grasping/plan_options.hpp"

namespace quadrille::study {
namespace {

using Cells = std::vector<std::string>;

template <class Value>
std::string cell(const Value& value) {
  return fmt::format("{}", value);
}

std::string cell(bool value) { return value ? "1" : "0"; }

std::string to_string(Tries tries) {
  if (tries == Tries::kNone) return "none";
  return tries == Tries::kFirst ? "first" : "all";
}

Cells with(Cells cells, const Cells& more) {
  cells.insert(cells.end(), more.begin(), more.end());
  return cells;
}

/// Returns the columns of the label and those that the first line of a table names.
Cells columns_of(std::string_view line) {
  Cells columns;
  for (const auto& [column, value] : label_of({}, "", "", "")) columns.push_back(column);
  return with(std::move(columns), parse_csv(line).front().cells);
}

Cells start_of(const Label& label, const SceneName& name) {
  Cells cells;
  for (const auto& [column, value] : label) cells.push_back(value);
  return with(std::move(cells), {cell(name.number), name.input, name.seed});
}

Cells pose_cells(const Eigen::Isometry3d& X) {
  const Eigen::Vector3d p = X.translation();
  const Eigen::Quaterniond q(X.linear());
  return {cell(p.x()), cell(p.y()), cell(p.z()), cell(q.w()),
          cell(q.x()), cell(q.y()), cell(q.z())};
}

Cells judged_cells(const GraspRecord& record) {
  Cells cells(3);
  if (record.verdict) cells[0] = to_string(*record.verdict);
  if (record.object >= 0) cells[1] = cell(record.object);
  cells[2] = record.object_type;
  if (!record.attempt) return with(std::move(cells), Cells(3));
  const physics::Attempt& attempt = *record.attempt;
  return with(std::move(cells),
              {to_string(attempt.outcome), cell(attempt.trial.slip), cell(attempt.trial.rotation)});
}

/// Counts of the grasps of a scene.
struct GraspCounts {
  int all = 0, judged = 0, good = 0, touching = 0, tried = 0, held = 0;

  void add(const GraspRecord& record) {
    ++all;
    judged += record.verdict.has_value();
    good += record.verdict == Verdict::kGood;
    touching += record.verdict == Verdict::kTouches;
    if (!record.attempt) return;
    tried += record.attempt->outcome != physics::Outcome::kUntried;
    held += record.attempt->outcome == physics::Outcome::kHeld;
  }
};

/// Returns the cells of the counts; they are empty for what was not judged or tried.
Cells count_cells(const GraspCounts& counts, bool truth, bool tried) {
  const auto if_there = [](bool there, int count) { return there ? cell(count) : std::string(); };
  return {cell(counts.all), if_there(truth, counts.good), if_there(truth, counts.touching),
          if_there(tried, counts.tried), if_there(tried, counts.held)};
}

}  // namespace

Label label_of(const StudyOptions& options, const std::string& version, const std::string& family,
               const std::string& settings) {
  return {{"version", version},
          {"family", family},
          {"gripper", options.gripper.name},
          {"unknown", std::string(quadrille::to_string(options.plan.unknown))},
          {"detector_seed", cell(options.detector.seed)},
          {"tries", to_string(options.tries)},
          {"friction", cell(options.trial.friction)},
          {"density", cell(options.trial.density)},
          {"force", cell(options.trial.force)},
          {"settings", io::hash_text(settings)}};
}

const Cells& grasp_columns() {
  static const Cells columns = columns_of(
      "scene,input,seed,rank,first,target,type,score,x,y,z,qw,qx,qy,qz,width,preshape,approach,"
      "friction_needed,epsilon,clearance,unknown_contact,verdict,object,object_type,outcome,slip,"
      "rotation\n");
  return columns;
}

const Cells& scene_columns() {
  static const Cells columns = columns_of(
      "scene,input,seed,points,detections,boxes,rejected,grasps,grasps_good,grasps_touching,"
      "grasps_tried,grasps_held,first,first_good,first_touching,first_tried,first_held,objects,"
      "objects_with_grasp,objects_with_good,objects_with_held,error\n");
  return columns;
}

std::vector<Cells> grasp_rows(const Label& label, const SceneName& name,
                              const SceneRecord& record) {
  std::vector<Cells> rows;
  for (const GraspRecord& r : record.grasps) {
    const Grasp& grasp = r.grasp;
    Cells cells =
        with(start_of(label, name), {cell(rows.size() + 1), cell(r.first), cell(grasp.target),
                                     r.target_type, cell(grasp.score)});
    cells = with(std::move(cells), pose_cells(grasp.X_CG));
    cells = with(std::move(cells), {cell(grasp.width), cell(grasp.preshape), cell(grasp.approach),
                                    cell(grasp.friction_needed), cell(grasp.epsilon),
                                    cell(grasp.clearance), cell(grasp.unknown_contact)});
    rows.push_back(with(std::move(cells), judged_cells(r)));
  }
  return rows;
}

Cells scene_row(const Label& label, const SceneName& name, const SceneRecord& record) {
  GraspCounts all, first;
  for (const GraspRecord& r : record.grasps) {
    all.add(r);
    if (r.first) first.add(r);
  }
  const bool truth = record.objects.has_value();
  bool tried = false;
  for (const auto& [column, value] : label) tried |= truth && column == "tries" && value != "none";
  Cells cells = with(start_of(label, name), {cell(record.points), cell(record.detections),
                                             cell(record.boxes), cell(record.rejected)});
  cells = with(std::move(cells), count_cells(all, truth, tried));
  cells = with(std::move(cells), count_cells(first, truth, tried));
  if (!truth) return with(std::move(cells), Cells(5));
  const ObjectCounts& o = *record.objects;
  return with(std::move(cells), {cell(o.all), cell(o.with_grasp), cell(o.with_good),
                                 tried ? cell(o.with_held) : "", ""});
}

Cells failed_row(const Label& label, const SceneName& name, const std::string& error) {
  Cells cells = start_of(label, name);
  cells.resize(scene_columns().size());
  cells.back() = error;
  return cells;
}

}  // namespace quadrille::study
