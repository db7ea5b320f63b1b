#include <fmt/format.h>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/generated_scenes.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/sphere_errors.hpp"
#include "lab/scoring/frame.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::experiments {
namespace {

std::vector<KnownSphere> spheres_of(const scoring::Frame& frame, const scene::Rendering& ideal) {
  std::vector<KnownSphere> spheres;
  for (const scoring::TrueSurface& surface : frame.surfaces) {
    const int visible = ideal.visible[static_cast<std::size_t>(surface.id)];
    if (surface.type != "sphere" || visible < kMinPixels) continue;
    const CanonicalForm form = canonical_form(surface.Q_C);
    spheres.push_back({form.X.translation(), form.dimensions.front().second});
  }
  return spheres;
}

/// One of the two searches, over the scenes of a family.
struct Search {
  DetectorOptions options;
  std::vector<SphereError> errors;
  /// Processor time of each scene [ms].
  std::vector<double> times;
  int wrong = 0;

  void run(const scoring::Frame& frame, const std::vector<KnownSphere>& spheres) {
    DetectionResult result;
    times.push_back(1e-3 * microseconds([&] { result = detect(frame.cloud, options); }));
    wrong += false_spheres(frame, result);
    for (const KnownSphere& truth : spheres) errors.push_back(match(result, truth));
  }
  std::string found() const {
    std::ptrdiff_t count = 0;
    for (const SphereError& error : errors) count += error.found;
    return fmt::format("{} of {}", count, errors.size());
  }
};

/// The search for all types, and the search for spheres alone.
struct Searches {
  Search all, alone;
};

void report_times(const std::map<std::string, Searches>& families, Report* report) {
  Table table{
      "Time of the search for spheres alone, one thread, median over the scenes",
      {"set", "scenes", "all types [ms]", "spheres alone [ms]", "times faster", "found: all types",
       "found: spheres alone", "false: all types", "false: spheres alone"},
      {}};
  Search every;
  std::vector<double> all;
  for (const auto& [name, s] : families) {
    const double slow = quantile(s.all.times, 0.5), fast = quantile(s.alone.times, 0.5);
    table.row(name, fmt::format("{}", s.all.times.size()), slow, fast, slow / fast, s.all.found(),
              s.alone.found(), fmt::format("{}", s.all.wrong), fmt::format("{}", s.alone.wrong));
    all.insert(all.end(), s.all.times.begin(), s.all.times.end());
    every.times.insert(every.times.end(), s.alone.times.begin(), s.alone.times.end());
  }
  report->findings.push_back(fmt::format(
      "The search for spheres alone takes {} ms in the median of {} scenes, that for all types {}.",
      number(quantile(every.times, 0.5)), every.times.size(), number(quantile(all, 0.5))));
  report->tables.push_back(table);
}

}  // namespace

Report run_spheres(const Settings& settings) {
  const int scenes = settings.quick ? 3 : 100;
  std::map<std::string, Searches> searches;
  for_each_scene({scene::Family::kEasy, scene::Family::kMedium, scene::Family::kHard}, scenes,
                 settings, [&](const scene::Scene& made) {
                   Searches& both = searches[scene::traits_of(made.options.family).name];
                   both.alone.options = sphere_preset();
                   const scoring::Frame frame = scoring::frame_of(made);
                   for (Search* search : {&both.all, &both.alone}) {
                     search->run(frame, spheres_of(frame, made.ideal));
                   }
                 });
  std::map<std::string, std::vector<SphereError>> groups;
  for (const auto& [name, both] : searches) {
    if (!both.all.errors.empty()) groups[name] = both.all.errors;
  }
  Report report = report_errors(groups);
  report_times(searches, &report);
  return report;
}

}  // namespace quadrille::experiments
