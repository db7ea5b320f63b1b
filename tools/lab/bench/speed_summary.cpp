#include "lab/bench/speed_summary.hpp"

#include "lab/bench/floor.hpp"

namespace quadrille::bench {
namespace {

StageSpeed& stage_of(const std::string& stage, SpeedSet* set) {
  for (StageSpeed& known : set->stages) {
    if (known.stage == stage) return known;
  }
  set->stages.push_back({stage, 0.0, 0.0, 0.0, 0.0, 0.0});
  return set->stages.back();
}

/// Adds a cloud's costs to those of its set.
/// @param stored  the cloud's counts in the baseline; none if unknown
void add(const CloudSpeed& cloud, const Instructions& stored, SpeedSet* set) {
  for (const StageTime& time : cloud.stages) {
    StageSpeed& stage = stage_of(time.stage, set);
    const bool on_points = works_on(time.stage) == WorksOn::kPoints;
    stage.ms += time.ms;
    stage.floor_ms += on_points ? cloud.points_ms : cloud.samples_ms;
    stage.instructions += static_cast<double>(instructions_of(cloud.counts, time.stage));
    stage.floor_instructions += static_cast<double>(
        instructions_of(cloud.counts, on_points ? kPassOverPoints : kPassOverSamples));
  }
  for (const auto& [stage, count] : stored) {
    stage_of(stage, set).stored += static_cast<double>(count);
  }
  set->total.ms += cloud.total_ms;
  set->cgal_ms += cloud.cgal_ms;
  ++set->clouds;
}

/// Says why a cloud cannot be compared with the baseline; empty if it can.
std::string why_not_compared(const CloudSpeed& cloud, const SpeedBaseline& baseline,
                             const std::string& built_by) {
  if (cloud.counts.empty()) return "no instructions were counted";
  if (baseline.built_by != built_by) {
    return "the baseline is of another build (" + baseline.built_by + ") than this (" + built_by +
           ")";
  }
  const auto known = baseline.clouds.find(cloud.name);
  if (known == baseline.clouds.end()) return "the baseline does not know " + cloud.name;
  if (known->second.points != cloud.points) {
    return "the baseline knows another " + cloud.name + ", of " +
           std::to_string(known->second.points) + " points";
  }
  return "";
}

/// Turns sums into means, and sums up the stages. What was not counted or not stored becomes NaN.
void finish(bool counted, SpeedSet* set) {
  const double nan = std::nan(""), n = set->clouds;
  StageSpeed& total = set->total;
  total.instructions = total.floor_instructions = total.stored = 0.0;
  for (StageSpeed& stage : set->stages) {
    stage.ms /= n, stage.floor_ms /= n;
    stage.instructions = counted ? stage.instructions / n : nan;
    stage.floor_instructions = counted ? stage.floor_instructions / n : nan;
    stage.stored = set->not_compared.empty() ? stage.stored / n : nan;
    total.floor_ms += stage.floor_ms;
    total.instructions += stage.instructions;
    total.floor_instructions += stage.floor_instructions;
    total.stored += stage.stored;
  }
  total.ms /= n;
  set->cgal_ms /= n;
}

SpeedSet& set_of(const std::string& name, std::vector<SpeedSet>* sets) {
  for (SpeedSet& set : *sets) {
    if (set.name == name) return set;
  }
  SpeedSet& set = sets->emplace_back();
  set.name = name;
  set.total.stage = "all";
  set.cgal_ms = 0.0;
  return set;
}

}  // namespace

std::vector<SpeedSet> summarise(const std::vector<CloudSpeed>& clouds,
                                const SpeedBaseline& baseline, const std::string& built_by) {
  std::vector<SpeedSet> sets;
  bool counted = true;
  for (const CloudSpeed& cloud : clouds) {
    SpeedSet& set = set_of(cloud.set, &sets);
    const std::string why_not = why_not_compared(cloud, baseline, built_by);
    if (set.not_compared.empty()) set.not_compared = why_not;
    counted = counted && !cloud.counts.empty();
    add(cloud, why_not.empty() ? baseline.clouds.at(cloud.name).stages : Instructions(), &set);
  }
  for (SpeedSet& set : sets) finish(counted, &set);
  return sets;
}

SpeedBaseline baseline_of(const std::vector<CloudSpeed>& clouds, const std::string& built_by) {
  SpeedBaseline baseline{built_by, {}};
  for (const CloudSpeed& cloud : clouds) {
    SpeedBaseline::Cloud& stored = baseline.clouds[cloud.name];
    stored.points = cloud.points;
    for (const StageTime& time : cloud.stages) {
      stored.stages.emplace_back(time.stage, instructions_of(cloud.counts, time.stage));
    }
  }
  return baseline;
}

}  // namespace quadrille::bench
