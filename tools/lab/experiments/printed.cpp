#include <fmt/format.h>

#include <string>
#include <vector>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/generated_scenes.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/printed/detect_printed.hpp"
#include "lab/printed/steps.hpp"
#include "lab/scoring/score.hpp"

namespace quadrille::experiments {
namespace {

/// A step, and its results on all scenes of a family.
struct StepResult {
  scene::Family family = scene::Family::kMedium;
  printed::Step step;
  scoring::FrameScore score;
  /// Processor time for each scene [ms].
  std::vector<double> times;
};

/// Returns the settings of the printed pipeline. A quick run has a smaller pool.
printed::Settings settings_of(const Settings& settings) {
  printed::Settings read = settings.config.empty() ? printed::printed_settings()
                                                   : printed::load_settings(settings.config);
  if (!settings.quick) return read;
  read.printed.pool /= 4;
  read.printed.min_members = 1 + read.printed.min_members / 4;
  return read;
}

void run(const scoring::Frame& frame, StepResult* result) {
  DetectionResult found;
  const double us =
      microseconds([&] { found = printed::detect_printed(frame.cloud, result->step.settings); });
  result->score += scoring::score(frame, scoring::findings_of(found));
  result->times.push_back(1e-3 * us);
}

Report report_of(const std::vector<StepResult>& all, int scenes) {
  Report report;
  Table table{fmt::format("From the printed pipeline to the detector, {} scenes each", scenes),
              {"scenes", "with", "surfaces", "recall", "precision", "planes found", "ms"},
              {}};
  report.data.columns = {"family", "step",         "known",        "found",
                         "wrong",  "planes_known", "planes_found", "median_ms"};
  for (const StepResult& r : all) {
    const std::string family = scene::traits_of(r.family).name;
    const double ms = quantile(r.times, 0.5);
    table.row(family, r.step.name, r.score.wanted, fmt::format("{:.3f}", r.score.recall()),
              fmt::format("{:.3f}", r.score.precision()),
              fmt::format("{:.3f}", r.score.plane_recall()), ms);
    report.data.row(family, r.step.name, r.score.wanted, r.score.found, r.score.wrong,
                    r.score.planes_wanted, r.score.planes_found, ms);
    report.findings.push_back(
        fmt::format("{}, {}: {} of {} curved surfaces found, and {} false ones, in {} ms.", family,
                    r.step.name, r.score.found, r.score.wanted, r.score.wrong, number(ms)));
  }
  report.tables = {table};
  return report;
}

}  // namespace

Report run_printed(const Settings& settings) {
  const int scenes = settings.quick ? 1 : 16;
  const std::vector<scene::Family> families = {scene::Family::kMedium, scene::Family::kHard};
  std::vector<StepResult> all;
  for (const scene::Family family : families) {
    for (const printed::Step& step : printed::steps_from(settings_of(settings))) {
      all.push_back({family, step, {}, {}});
    }
  }
  for_each_scene(families, scenes, settings, [&](const scene::Scene& made) {
    const scoring::Frame frame = scoring::frame_of(made);
    for (StepResult& result : all) {
      if (result.family == made.options.family) run(frame, &result);
    }
  });
  return report_of(all, scenes);
}

}  // namespace quadrille::experiments
