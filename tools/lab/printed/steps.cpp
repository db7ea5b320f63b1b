#include "lab/printed/steps.hpp"

namespace quadrille::printed {

std::vector<Step> steps_from(const Settings& printed) {
  const Settings detector;
  std::vector<Step> steps = {{"as printed", printed}};
  Settings next = printed;
  const auto add = [&](std::string_view name) { steps.push_back({name, next}); };

  next.detector.sampling = detector.detector.sampling;
  add("cells in metres");

  if (next.printed.surfaces == Surfaces::kInliers) next.printed.surfaces = Surfaces::kEvidence;
  add("evidence instead of a count");

  const GrowOptions grow = next.detector.search.grow;
  const int axes = next.detector.search.axes;
  next.printed.pool = 0;
  next.detector.search = detector.detector.search;
  next.detector.search.grow = grow;
  next.detector.search.axes = axes;
  next.detector.aggregate = detector.detector.aggregate;
  add("each neighbourhood by itself");

  next.printed.levels = detector.printed.levels;
  add("three levels of cells");

  next.detector.search.grow = detector.detector.search.grow;
  add("growth with refits");

  next.printed.surfaces = detector.printed.surfaces;
  add("claims, and a last fit");

  next = detector;
  next.detector.seed = printed.detector.seed;
  add("surfaces about axes: the detector");
  return steps;
}

}  // namespace quadrille::printed
