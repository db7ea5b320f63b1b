#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/generated_scenes.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/scoring/score.hpp"
#include "variants/variant.hpp"

namespace quadrille::experiments {
namespace {

struct SamplingWay {
  const char* name;
  VariantBasis basis;
};
constexpr SamplingWay kWays[] = {{"2 points, vote", VariantBasis::kTwoPoints},
                                 {"3 points, vote", VariantBasis::kThreePoints},
                                 {"4 points", VariantBasis::kFourPoints},
                                 {"9 points", VariantBasis::kNinePoints}};

const std::vector<scene::Family> kFamilies = {scene::Family::kMedium, scene::Family::kHard};

/// One setting of the detector, and its results on all scenes of a family.
struct SamplingSetting {
  const char* name;
  scene::Family family;
  DetectorOptions options;
  Variant variant;
  scoring::FrameScore score;
  /// Processor time of the detection and wall time of its search for each scene [ms].
  std::vector<double> total, search;

  bool is(const char* way, scene::Family scenes) const {
    return name == std::string_view(way) && family == scenes;
  }
  double median_total() const { return quantile(total, 0.5); }
  double median_search() const { return quantile(search, 0.5); }
};

double stage_time(const DetectionResult& result, std::string_view stage) {
  for (const StageTime& time : result.timings) {
    if (time.stage == stage) return time.ms;
  }
  return 0.0;
}

void run(const scoring::Frame& frame, SamplingSetting* setting) {
  DetectionResult result;
  const double us = microseconds(
      [&] { result = detect_variant(frame.cloud, setting->options, setting->variant); });
  setting->score += scoring::score(frame, scoring::findings_of(result));
  setting->total.push_back(1e-3 * us);
  setting->search.push_back(stage_time(result, "search"));
}

/// Returns every sampler at each cell size with the default number of bases, and at the default
/// cell size with each number of bases.
std::vector<SamplingSetting> all_settings(scene::Family family, bool quick) {
  // Cell sizes relative to the default.
  const std::vector<double> cells =
      quick ? std::vector<double>{1, 4} : std::vector<double>{0.5, 0.7, 1, 1.4, 2, 2.8, 4, 5.6};
  const std::vector<int> bases = quick ? std::vector<int>{1} : std::vector<int>{1, 2, 10, 20};
  std::vector<SamplingSetting> settings;
  for (const SamplingWay& way : kWays) {
    SamplingSetting setting{way.name, family, {}, {.basis = way.basis}, {}, {}, {}};
    for (const double cell : cells) {
      settings.push_back(setting);
      settings.back().options.sampling.cell *= cell;
    }
    for (const int count : bases) {
      settings.push_back(setting);
      settings.back().options.search.bases = count;
    }
  }
  return settings;
}

bool has_default_bases(const SamplingSetting& s) {
  return s.options.search.bases == DetectorOptions().search.bases;
}
bool has_default_cell(const SamplingSetting& s) {
  return s.options.sampling.cell == DetectorOptions().sampling.cell;
}

/// Lists the samplers one below the other, setting by setting.
Table table_of(const std::string& title, std::vector<SamplingSetting> settings,
               bool (*belongs)(const SamplingSetting&)) {
  std::stable_sort(settings.begin(), settings.end(),
                   [](const SamplingSetting& a, const SamplingSetting& b) {
                     return std::tuple(a.family, a.options.sampling.cell, a.options.search.bases) <
                            std::tuple(b.family, b.options.sampling.cell, b.options.search.bases);
                   });
  Table table{title,
              {"scenes", "cell [mm]", "bases a seed", "way", "recall", "precision",
               "detection [ms]", "of it search [ms]"},
              {}};
  for (const SamplingSetting& s : settings) {
    if (!belongs(s)) continue;
    table.row(scene::traits_of(s.family).name, 1e3 * s.options.sampling.cell,
              s.options.search.bases, s.name, fmt::format("{:.3f}", s.score.recall()),
              fmt::format("{:.3f}", s.score.precision()), s.median_total(), s.median_search());
  }
  return table;
}

template <class Value>
std::vector<Series> lines_of(const std::vector<SamplingSetting>& settings,
                             bool (*belongs)(const SamplingSetting&), const Value& point) {
  std::vector<Series> lines;
  for (const scene::Family family : kFamilies) {
    for (const SamplingWay& way : kWays) {
      Series line{fmt::format("{}, {}", way.name, scene::traits_of(family).name), {}};
      line.way = way.name;
      line.dashed = family != kFamilies[0];
      for (const SamplingSetting& s : settings) {
        if (belongs(s) && s.is(way.name, family)) line.points.push_back(point(s));
      }
      std::sort(line.points.begin(), line.points.end());
      lines.push_back(line);
    }
  }
  return lines;
}

std::vector<Plot> plots_of(const std::vector<SamplingSetting>& settings) {
  const auto cell = [](const SamplingSetting& s) { return 1e3 * s.options.sampling.cell; };
  const auto recall = [&](const SamplingSetting& s) {
    return std::pair(cell(s), s.score.recall());
  };
  const auto time = [&](const SamplingSetting& s) { return std::pair(cell(s), s.median_search()); };
  const auto trade = [](const SamplingSetting& s) {
    return std::pair(s.median_search(), s.score.recall());
  };
  return {
      {"Found over the sampling",
       "cell [mm]",
       "recall",
       lines_of(settings, has_default_bases, recall),
       true,
       false,
       {0.0, 1.0}},
      {"Time over the sampling", "cell [mm]", "search, median [ms]",
       lines_of(settings, has_default_bases, time), true, true},
      {"Found over time, at the default cell",
       "search, median [ms]",
       "recall",
       lines_of(settings, has_default_cell, trade),
       true,
       false,
       {0.0, 1.0}},
  };
}

/// Tells the least time at which each sampler reaches a share of a family's best recall.
std::string fastest(const std::vector<SamplingSetting>& settings, scene::Family family,
                    double share) {
  double best = 0.0;
  for (const SamplingSetting& s : settings) {
    if (s.family == family) best = std::max(best, s.score.recall());
  }
  std::string list;
  for (const SamplingWay& way : kWays) {
    const SamplingSetting* least = nullptr;
    for (const SamplingSetting& s : settings) {
      const bool suits = s.is(way.name, family) && s.score.recall() >= share * best;
      if (suits && (!least || s.median_total() < least->median_total())) least = &s;
    }
    list += list.empty() ? "" : "; ";
    list += least ? fmt::format("{} {} ms, of it search {}", way.name,
                                number(least->median_total()), number(least->median_search()))
                  : fmt::format("{} never", way.name);
  }
  return fmt::format("The fastest detection with {:.0f} % of the best recall, {} scenes: {}.",
                     100.0 * share, scene::traits_of(family).name, list);
}

Report report_of(const std::vector<SamplingSetting>& all, int scenes) {
  Report report;
  for (const scene::Family family : kFamilies) {
    const auto one = std::find_if(all.begin(), all.end(),
                                  [&](const SamplingSetting& s) { return s.family == family; });
    report.findings.push_back(fmt::format(
        "{} {} scenes with {} curved surfaces of which enough is seen; time is the median over the "
        "scenes, on one thread.",
        scenes, scene::traits_of(family).name, one->score.wanted));
    report.findings.push_back(fastest(all, family, 0.95));
  }
  report.tables = {table_of("Over the sampling", all, has_default_bases),
                   table_of("Over the bases a seed", all, has_default_cell)};
  report.data = {
      "",
      {"family", "cell_m", "bases", "way", "known", "found", "wrong", "total_ms", "search_ms"},
      {}};
  for (const SamplingSetting& s : all) {
    report.data.row(scene::traits_of(s.family).name, s.options.sampling.cell,
                    s.options.search.bases, s.name, s.score.wanted, s.score.found, s.score.wrong,
                    s.median_total(), s.median_search());
  }
  report.plots = plots_of(all);
  return report;
}

}  // namespace

Report run_sampling(const Settings& settings) {
  const int scenes = settings.quick ? 2 : 16;
  std::vector<SamplingSetting> all;
  for (const scene::Family family : kFamilies) {
    const std::vector<SamplingSetting> some = all_settings(family, settings.quick);
    all.insert(all.end(), some.begin(), some.end());
  }
  for_each_scene(kFamilies, scenes, settings, [&](const scene::Scene& made) {
    const scoring::Frame frame = scoring::frame_of(made);
    for (SamplingSetting& setting : all) {
      if (setting.family == made.options.family) run(frame, &setting);
    }
  });
  return report_of(all, scenes);
}

}  // namespace quadrille::experiments
