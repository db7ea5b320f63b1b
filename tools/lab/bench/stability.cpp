#include "lab/bench/stability.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "io/cloud_file.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/pinhole.hpp"

namespace quadrille::bench {
namespace {

/// A surface, as the first run that found it saw it, and all detections of it.
struct Found {
  Eigen::Vector3d centre_C;
  double size = 0.0;
  std::vector<const Detection*> detections;
};

Found found_by(const Detection& d) {
  return {d.X_CQ * d.extent_Q.center(), d.extent_Q.diagonal().norm(), {&d}};
}

/// Pairs the detections of a run with the surfaces of earlier ones, the nearest first, and adds
/// those that are left over.
void add_run(const std::vector<Detection>& run, std::vector<Found>* surfaces) {
  std::vector<Found> news;
  for (const Detection& d : run) {
    if (is_reported(d) && !is_flat(d.type)) news.push_back(found_by(d));
  }
  // Distance, surface, detection.
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t s = 0; s < surfaces->size(); ++s) {
    for (std::size_t d = 0; d < news.size(); ++d) {
      const double distance = ((*surfaces)[s].centre_C - news[d].centre_C).norm();
      const double size = 0.5 * ((*surfaces)[s].size + news[d].size);
      if (distance < kSameDistance * size) pairs.emplace_back(distance, s, d);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<char> paired(surfaces->size(), 0), known(news.size(), 0);
  for (const auto& [distance, s, d] : pairs) {
    if (paired[s] || known[d]) continue;
    paired[s] = known[d] = 1;
    (*surfaces)[s].detections.push_back(news[d].detections.front());
  }
  for (std::size_t d = 0; d < news.size(); ++d) {
    if (!known[d]) surfaces->push_back(std::move(news[d]));
  }
}

bool has_one_type(const Found& found) {
  return std::all_of(found.detections.begin(), found.detections.end(),
                     [&](const Detection* d) { return d->type == found.detections.front()->type; });
}

bool is_sure(const Found& found) {
  return std::any_of(found.detections.begin(), found.detections.end(),
                     [](const Detection* d) { return d->score >= kSureScore; });
}

/// Drops the points in the first columns and rows of pixels; in an organised cloud they are
/// missing.
void crop(PointCloud* cloud, const PinholeView& view, const PinholeImage& image, int pixels) {
  const Eigen::Array2f first = image.corner + static_cast<float>(pixels) * image.pitch;
  for (Eigen::Vector3f& p : cloud->points) {
    const Eigen::Vector3f t = view(p);
    if (t.z() > 0.0f && (t.head<2>().array() < first).any()) {
      p.setConstant(std::numeric_limits<float>::quiet_NaN());
    }
  }
  if (!cloud->organised()) {
    std::erase_if(cloud->points, [](const Eigen::Vector3f& p) { return !p.allFinite(); });
  }
  cloud->colours.clear();
}

}  // namespace

StabilityCounts& StabilityCounts::operator+=(const StabilityCounts& other) {
  in_any += other.in_any, in_all += other.in_all, same_type += other.same_type;
  sure_in_any += other.sure_in_any, sure_in_all += other.sure_in_all;
  return *this;
}

StabilityCounts count_stable(std::span<const std::vector<Detection>> runs) {
  std::vector<Found> surfaces;
  for (const std::vector<Detection>& run : runs) add_run(run, &surfaces);
  StabilityCounts counts;
  for (const Found& found : surfaces) {
    const bool in_all = found.detections.size() == runs.size(), sure = is_sure(found);
    ++counts.in_any;
    counts.in_all += in_all;
    counts.same_type += in_all && has_one_type(found);
    counts.sure_in_any += sure;
    counts.sure_in_all += sure && in_all;
  }
  return counts;
}

PointCloud shifted(PointCloud cloud, int pixels, const DetectorOptions& options) {
  if (pixels == 0) return cloud;
  const std::optional<PinholeView> view = find_view(cloud);
  const std::optional<PinholeImage> image = view ? find_image(cloud, *view) : std::nullopt;
  if (image) {
    crop(&cloud, *view, *image, pixels);
    return cloud;
  }
  const double step = options.sampling.cell / kStabilityRuns;
  return moved(std::move(cloud),
               Eigen::Isometry3d(Eigen::Translation3d(Eigen::Vector3d::Constant(pixels * step))));
}

std::vector<Stability> measure_stability(const std::vector<std::string>& clouds,
                                         const DetectorOptions& options,
                                         const std::function<void(double)>& progress) {
  std::vector<Stability> list;
  double done = 0.0;
  for (const std::string& path : clouds) {
    const PointCloud cloud = io::read_cloud(path);
    std::vector<std::vector<Detection>> seeds, shifts;
    DetectorOptions seeded = options;
    for (int k = 0; k < kStabilityRuns; ++k) {
      seeded.seed = static_cast<std::uint64_t>(1 + k);
      seeds.push_back(detect(cloud, seeded).detections);
      seeded.seed = 1;
      shifts.push_back(k == 0 ? seeds.front()
                              : detect(shifted(cloud, k, options), seeded).detections);
      progress(++done / static_cast<double>(kStabilityRuns * clouds.size()));
    }
    list.push_back({path, count_stable(seeds), count_stable(shifts)});
  }
  return list;
}

}  // namespace quadrille::bench
