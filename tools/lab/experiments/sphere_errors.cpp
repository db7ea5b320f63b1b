#include "lab/experiments/sphere_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/experiments/measure.hpp"
#include "lab/scoring/score.hpp"

namespace quadrille::experiments {
namespace {

std::vector<double> sizes_of(const std::vector<SphereError>& errors, double SphereError::*measure) {
  std::vector<double> sizes;
  for (const SphereError& error : errors) {
    if (error.found) sizes.push_back(std::abs(error.*measure));
  }
  return sizes;
}

std::string as_percent(double share) { return fmt::format("{:.2f} %", 100.0 * share); }

Series distribution(const std::string& set, const std::string& measure,
                    const std::vector<double>& sizes, bool dashed) {
  Series line{set + ", " + measure, {}, dashed, false, set};
  for (double share = 0.0; share <= 1.001; share += 0.05) {
    line.points.emplace_back(100.0 * quantile(sizes, std::min(1.0, share)), share);
  }
  return line;
}

}  // namespace

SphereError match(const DetectionResult& result, const KnownSphere& truth) {
  SphereError best;
  for (const Detection& detection : result.detections) {
    const bool sphere = detection.type == QuadricType::kSphere;
    if (!sphere && detection.type != QuadricType::kEllipsoid) continue;
    double radius = 0.0;
    for (const Dimension& dimension : detection.dimensions) radius += dimension.value;
    radius /= static_cast<double>(detection.dimensions.size());
    const double centre = (detection.X_CQ.translation() - truth.centre_C).norm() / truth.radius;
    if (centre > 1.0 || (best.found && best.centre <= centre)) continue;
    best = {true, radius / truth.radius - 1.0, centre};
  }
  return best;
}

int false_spheres(const scoring::Frame& frame, DetectionResult result) {
  std::erase_if(result.detections,
                [](const Detection& d) { return d.type != QuadricType::kSphere; });
  return scoring::score(frame, scoring::findings_of(result), "sphere").wrong;
}

Report report_errors(const std::map<std::string, std::vector<SphereError>>& groups) {
  Report report;
  Table table{"Errors in shares of the radius",
              {"set", "spheres", "found", "radius: mean error", "median |error|", "90 %",
               "centre: median error", "90 %"},
              {}};
  report.data.columns = {"set", "found", "radius_error", "centre_error"};
  Plot plot{
      "Distribution of the errors", "error [% of the radius]", "share of the found", {}, true};
  for (const auto& [name, errors] : groups) {
    double sum = 0.0;
    for (const SphereError& error : errors) {
      report.data.row(name, error.found ? "1" : "0", error.radius, error.centre);
      sum += error.radius;
    }
    const std::vector<double> radius = sizes_of(errors, &SphereError::radius);
    const std::vector<double> centre = sizes_of(errors, &SphereError::centre);
    const std::string count = fmt::format("{}", errors.size());
    if (radius.empty()) {
      table.row(name, count, "0", "-", "-", "-", "-", "-");
      continue;
    }
    table.row(name, count, fmt::format("{}", radius.size()),
              as_percent(sum / static_cast<double>(radius.size())),
              as_percent(quantile(radius, 0.5)), as_percent(quantile(radius, 0.9)),
              as_percent(quantile(centre, 0.5)), as_percent(quantile(centre, 0.9)));
    report.findings.push_back(fmt::format(
        "{}: {} of {} found; median error of the radius {}, of the centre {}.", name, radius.size(),
        errors.size(), as_percent(quantile(radius, 0.5)), as_percent(quantile(centre, 0.5))));
    plot.lines.push_back(distribution(name, "radius", radius, false));
    plot.lines.push_back(distribution(name, "centre", centre, true));
  }
  report.tables = {table};
  report.plots = {plot};
  return report;
}

}  // namespace quadrille::experiments
