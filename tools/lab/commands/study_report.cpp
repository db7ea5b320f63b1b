#include "lab/commands/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cli/command_line.hpp"
#include "view/report_file.hpp"
#include "view/scene/scene_of_cloud.hpp"

namespace quadrille {
namespace {

/// Number of clouds in a report; people would not look at more.
constexpr std::size_t kMaxClouds = 12;

view::ReportTable table_of(const study::GroupSummary& group) {
  view::ReportTable table{
      fmt::format("{}: {} scenes, {} grasps", group.name, group.scenes, group.grasps),
      {"share of", "", "", "95 %, by Wilson"},
      {}};
  for (const study::Figure& figure : study::figures_of(group)) {
    const auto [counts, share, interval] = study::words_of(figure.ratio);
    table.rows.push_back({figure.name, counts, share, interval});
  }
  return table;
}

/// Returns how a grasp ended if it was tried, and otherwise the judge's verdict.
std::string outcome_of(const study::GraspRecord& record) {
  if (record.attempt) return to_string(record.attempt->outcome);
  if (record.verdict) return fmt::format("judged {}", study::to_string(*record.verdict));
  return "";
}

view::Scene scene_of(const study::StudyInput& input, const std::string& name,
                     const study::StudyOptions& options) {
  const view::PlanSetup setup = {options.detector, options.plan, options.gripper, {}, {}, {}};
  view::Scene scene = view::scene_of_cloud(input.cloud, input.X_CK, setup);
  scene.name = name;
  for (const study::GraspRecord& record : study::study_scene(input, options).grasps) {
    scene.outcomes.push_back(outcome_of(record));
  }
  return scene;
}

}  // namespace

void write_study_report(const std::string& path, const study::Study& study,
                        const std::vector<study::GroupSummary>& groups,
                        const std::string& settings) {
  view::ReportFile file(path, fmt::format("study of {} clouds", study.names.size()), command_line(),
                        settings);
  view::Report& report = file.report();
  for (const study::GroupSummary& group : groups) report.add_table(table_of(group));
  const std::size_t shown = std::min(study.names.size(), kMaxClouds);
  for (std::size_t n = 0; n < shown; ++n) {
    const std::string& name = study.names[n].input;
    try {
      report.add_scene(scene_of(study.input(n), name, study.options), true);
    } catch (const std::runtime_error& error) {
      report.add_note(fmt::format("{}: {}", name, error.what()));
    }
  }
  if (shown < study.names.size()) {
    report.add_note(fmt::format("the first {} of {} clouds are shown", shown, study.names.size()));
  }
  file.finish();
}

}  // namespace quadrille
