#include <fmt/format.h>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/generated_scenes.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/scoring/score.hpp"
#include "lab/trials/search_samples.hpp"
#include "search/search.hpp"
#include "variants/variant.hpp"

namespace quadrille::experiments {
namespace {

/// The search with a given number of bases, with or without the hash, over all scenes of a family.
struct Setting {
  scene::Family family = scene::Family::kMedium;
  DetectorOptions options;
  Variant variant;
  /// Consistent bases that were voted on, and repeated bases that were skipped.
  std::size_t voted = 0, repeats = 0;
  /// Processor time of the search over all levels, for each scene [ms].
  std::vector<double> times;
  scoring::FrameScore score;

  double repeated() const {
    const auto all = voted + repeats;
    return all ? static_cast<double>(repeats) / static_cast<double>(all) : 0.0;
  }
};

void run(const scoring::Frame& frame, const SampleTree& tree, Setting* setting) {
  const DetectorOptions& options = setting->options;
  setting->times.push_back(
      1e-3 * microseconds([&] {
        for (int l = 0; l < kLevels; ++l) {
          const SurfaceSamples& samples = tree.level(l);
          TripletSet seen;
          search(samples, std::vector<char>(static_cast<std::size_t>(samples.size()), 1),
                 options.search, options.inlier, options.seed,
                 propose_variant(setting->variant, options.search.bases,
                                 setting->variant.hash_triplets ? &seen : nullptr));
          setting->voted += seen.size();
          setting->repeats += seen.repeats();
        }
      }));
  const DetectionResult result = detect_variant(frame.cloud, options, setting->variant);
  setting->score += scoring::score(frame, scoring::findings_of(result));
}

/// The same number of bases without the hash, with it, and with it only in the largest
/// neighbourhood of each seed.
struct Group {
  Setting plain, hashed, single;
};

std::vector<Group> all_groups(scene::Family family, bool quick) {
  std::vector<Group> groups;
  for (const int bases : quick ? std::vector<int>{5, 50} : std::vector<int>{5, 50, 500}) {
    Setting setting;
    setting.family = family;
    setting.options.search.bases = bases;
    Group group{setting, setting, setting};
    group.hashed.variant.hash_triplets = true;
    group.single.variant.hash_triplets = true;
    group.single.options.search.radii = {setting.options.search.radii.back()};
    groups.push_back(group);
  }
  return groups;
}

std::string percent(double share) { return fmt::format("{:.2f} %", 100.0 * share); }

Table table_of(const std::vector<Group>& groups, int scenes) {
  Table table{fmt::format("Triplets that were bases before, {} scenes each", scenes),
              {"scenes", "bases a seed", "consistent triplets", "repeated", "repeated, one radius",
               "search [ms]", "with hash [ms]", "recall", "with hash"},
              {}};
  for (const auto& [plain, hashed, single] : groups) {
    table.add({scene::traits_of(plain.family).name, number(plain.options.search.bases),
               fmt::format("{}", hashed.voted + hashed.repeats), percent(hashed.repeated()),
               percent(single.repeated()), number(quantile(plain.times, 0.5)),
               number(quantile(hashed.times, 0.5)), fmt::format("{:.3f}", plain.score.recall()),
               fmt::format("{:.3f}", hashed.score.recall())});
  }
  return table;
}

Table data_of(const std::vector<Group>& groups) {
  Table data{
      "", {"family", "bases", "setting", "voted", "repeated", "median_ms", "known", "found"}, {}};
  for (const Group& group : groups) {
    for (const auto& [name, s] : {std::pair("plain", &group.plain),
                                  {"hashed", &group.hashed},
                                  {"one radius", &group.single}}) {
      data.add({scene::traits_of(s->family).name, number(s->options.search.bases), name,
                fmt::format("{}", s->voted), fmt::format("{}", s->repeats),
                number(quantile(s->times, 0.5)), number(s->score.wanted), number(s->score.found)});
    }
  }
  return data;
}

Report report_of(const std::vector<Group>& groups, int scenes) {
  Report report;
  Plot plot{"Repeated triplets", "bases a seed", "repeated [%]", {}, true, false, {0.0}};
  for (const Group& group : groups) {
    const std::string family = scene::traits_of(group.plain.family).name;
    const int bases = group.plain.options.search.bases;
    report.findings.push_back(fmt::format(
        "{}: with {} bases a seed {} of the consistent triplets were bases before, with one radius "
        "{}.",
        family, bases, percent(group.hashed.repeated()), percent(group.single.repeated())));
    if (plot.lines.empty() || !plot.lines.back().name.starts_with(family)) {
      plot.lines.push_back({family + ", three radii", {}, false, false, family});
      plot.lines.push_back({family + ", one radius", {}, true, false, family});
    }
    (plot.lines.end() - 2)->points.emplace_back(bases, 100.0 * group.hashed.repeated());
    plot.lines.back().points.emplace_back(bases, 100.0 * group.single.repeated());
  }
  report.tables = {table_of(groups, scenes)};
  report.data = data_of(groups);
  report.plots = {plot};
  return report;
}

}  // namespace

Report run_triplets(const Settings& settings) {
  const int scenes = settings.quick ? 2 : 12;
  const std::vector<scene::Family> families = {scene::Family::kMedium, scene::Family::kHard};
  std::vector<Group> all;
  for (const scene::Family family : families) {
    const std::vector<Group> groups = all_groups(family, settings.quick);
    all.insert(all.end(), groups.begin(), groups.end());
  }
  for_each_scene(families, scenes, settings, [&](const scene::Scene& made) {
    const scoring::Frame frame = scoring::frame_of(made);
    const auto samples = trials::search_samples(frame.cloud, {});
    for (Group& group : all) {
      if (group.plain.family != made.options.family) continue;
      for (Setting* setting : {&group.plain, &group.hashed, &group.single}) {
        run(frame, *samples->tree, setting);
      }
    }
  });
  return report_of(all, scenes);
}

}  // namespace quadrille::experiments
