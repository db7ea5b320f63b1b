#include "lab/bench/speed.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "io/cloud_file.hpp"
#include "lab/bench/contender.hpp"
#include "lab/bench/floor.hpp"
#include "lab/bench/stopwatch.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::bench {
namespace {

namespace fs = std::filesystem;

/// Keeps the smaller time of each stage.
void keep_best(const std::vector<StageTime>& run, std::vector<StageTime>* best) {
  if (best->empty()) *best = run;
  for (std::size_t k = 0; k < run.size(); ++k) {
    (*best)[k].ms = std::min((*best)[k].ms, run[k].ms);
  }
}

/// Best time of a pass [ms].
template <class Pass>
double time_of(const Pass& pass) {
  double best = std::numeric_limits<double>::max();
  for (int k = 0; k < kSpeedRuns; ++k) {
    const Stopwatch stopwatch;
    volatile const float sink = pass();
    static_cast<void>(sink);
    best = std::min(best, stopwatch.wall_ms());
  }
  return best;
}

void measure_times(const PointCloud& cloud, const DetectorOptions& options, CloudSpeed* speed) {
  speed->total_ms = std::numeric_limits<double>::max();
  for (int k = 0; k < kSpeedRuns; ++k) {
    const DetectionResult result = detect(cloud, options);
    keep_best(result.timings, &speed->stages);
    speed->total_ms = std::min(speed->total_ms, result.total_ms);
  }
  const SurfaceSamples samples = finest_samples(cloud, options);
  speed->points_ms = time_of([&] { return pass_over(cloud.points); });
  speed->samples_ms = time_of([&] { return pass_over(samples); });
}

/// CGAL's Efficient RANSAC, if it is built.
std::optional<Contender> find_cgal(const std::string& programs) {
  for (Contender& contender : all_contenders(programs)) {
    if (contender.name == "cgal" && contender.absent.empty()) return std::move(contender);
  }
  return std::nullopt;
}

/// Measures one cloud after the other.
class Meter {
 public:
  explicit Meter(const SpeedOptions& options)
      : options_(options),
        cgal_(find_cgal(options.programs)),
        counts_(why_not_counted(options.programs).empty()) {}

  CloudSpeed measure(const std::string& set, const std::string& name, PointCloud cloud) const {
    CloudSpeed speed;
    speed.set = set;
    speed.name = name;
    speed.points = cloud.points.size();
    measure_times(cloud, options_.config.detector, &speed);
    if (counts_) speed.counts = count_instructions(options_.programs, cloud, options_.config_path);
    if (cgal_) speed.cgal_ms = time_of_cgal(set, std::move(cloud));
    return speed;
  }

 private:
  double time_of_cgal(const std::string& family, PointCloud cloud) const {
    Frame frame;
    frame.family = family;
    frame.cloud = std::move(cloud);
    std::erase_if(frame.cloud.points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
    frame.cloud.width = frame.cloud.height = 0;
    return cgal_->run(frame).cpu_ms;
  }

  const SpeedOptions& options_;
  std::optional<Contender> cgal_;
  bool counts_;
};

/// Name of the folder in which a file lies.
std::string folder_of(const std::string& path) {
  return fs::absolute(path).lexically_normal().parent_path().filename().string();
}

}  // namespace

std::vector<CloudSpeed> measure_speed(const SpeedOptions& options) {
  const Meter meter(options);
  std::vector<CloudSpeed> list;
  if (options.frames.clouds.empty()) {
    for_each_frame(options.frames, [&](const Frame& frame, int) {
      list.push_back(meter.measure(frame.family, frame.name, frame.cloud));
    });
    return list;
  }
  const std::vector<std::string>& paths = options.frames.clouds;
  for (const std::string& path : paths) {
    const std::string set = folder_of(path);
    list.push_back(
        meter.measure(set, set + "/" + fs::path(path).stem().string(), io::read_cloud(path)));
    options.frames.progress(static_cast<double>(list.size()) / static_cast<double>(paths.size()));
  }
  return list;
}

}  // namespace quadrille::bench
