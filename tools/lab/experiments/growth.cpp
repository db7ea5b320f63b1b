#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <vector>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/scene/fused_cloud.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::experiments {
namespace {

/// Largest mean distance between a body's exact points and a quadric that counts as the body [m].
constexpr double kMaxMeanDistance = 0.002;

bool is_found(const scene::FusedThing& thing, const std::vector<Detection>& detections) {
  return std::any_of(detections.begin(), detections.end(), [&](const Detection& detection) {
    if (detection.type != thing.type) return false;
    double sum = 0.0;
    for (const Eigen::Vector3d& x : thing.exact_C) sum += std::abs(detection.Q_C.distance(x));
    return sum <= kMaxMeanDistance * static_cast<double>(thing.exact_C.size());
  });
}

/// Returns the most memory that the process has used so far [bytes].
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Returns the memory that the process uses now [bytes].
double present_memory() {
  std::ifstream pages("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  pages >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

Report run_growth(const Settings& settings) {
  const std::vector<int> sizes = settings.quick
                                     ? std::vector{10000, 100000}
                                     : std::vector{10000, 100000, 350000, 1000000, 10000000};
  const int rounds = settings.quick ? 1 : 3;
  Report report;
  report.data.columns = {"points", "ms", "bytes", "found", "things"};
  Table table{"Fused clouds, one thread, best of the rounds",
              {"points", "ms", "µs a point", "bytes a point", "found"},
              {}};
  double done = 0.0;
  for (const int size : sizes) {
    scene::Random random(settings.seed, static_cast<std::uint64_t>(size));
    const scene::FusedCloud fused = scene::make_fused_cloud(size, &random);
    const double before = present_memory();
    DetectionResult result;
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
      best = std::min(best, microseconds([&] { result = detect(fused.cloud); }));
    }
    const double bytes = peak_memory() - before;
    const auto found =
        std::count_if(fused.things.begin(), fused.things.end(),
                      [&](const scene::FusedThing& t) { return is_found(t, result.detections); });
    table.row(fmt::format("{}", size), 1e-3 * best, best / size, bytes / size,
              fmt::format("{} of {}", found, fused.things.size()));
    report.data.row(fmt::format("{}", size), 1e-3 * best, bytes, fmt::format("{}", found),
                    fmt::format("{}", fused.things.size()));
    settings.progress(done += 1.0 / static_cast<double>(sizes.size()));
  }
  report.findings = {fmt::format("Clouds of {} to {} points take {} to {} µs a point.",
                                 sizes.front(), sizes.back(), table.rows.front()[2],
                                 table.rows.back()[2])};
  report.tables = {table};
  return report;
}

}  // namespace quadrille::experiments
