#include "views/joined_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "samples/sample_buckets.hpp"

namespace quadrille {
namespace {

template <class T>
void append(const std::vector<T>& from, std::vector<T>* to) {
  to->insert(to->end(), from.begin(), from.end());
}

}  // namespace

SurfaceSamples joined_samples(std::span<const SurfaceSamples* const> views,
                              const std::vector<int>& first_cells, double view_shift) {
  SurfaceSamples joined;
  joined.view_shift = view_shift;
  joined.first.push_back(0);
  const float shift = static_cast<float>(view_shift);
  for (std::size_t v = 0; v < views.size(); ++v) {
    const SurfaceSamples& own = *views[v];
    const int first_sample = joined.size();
    const int first_neighbour = static_cast<int>(joined.neighbours.size());
    append(own.p, &joined.p);
    append(own.n, &joined.n);
    append(own.raw, &joined.raw);
    append(own.cell, &joined.cell);
    append(own.count, &joined.count);
    for (const float sigma : own.sigma) joined.sigma.push_back(std::hypot(sigma, shift));
    for (const int cell : own.source) joined.source.push_back(first_cells[v] + cell);
    for (const int i : own.neighbours) joined.neighbours.push_back(first_sample + i);
    for (int i = 0; i < own.size(); ++i) {
      joined.first.push_back(first_neighbour + own.first[i + 1]);
      joined.view.push_back(static_cast<int>(v));
    }
    joined.common_noise = std::max(joined.common_noise, own.common_noise);
  }
  return joined;
}

SurfaceSamples joined_places(std::span<const SurfaceSamples* const> views) {
  SurfaceSamples joined;
  for (const SurfaceSamples* own : views) {
    append(own->raw, &joined.raw);
    append(own->n, &joined.n);
    append(own->sigma, &joined.sigma);
    append(own->cell, &joined.cell);
  }
  return joined;
}

SurfaceSamples moved(SurfaceSamples samples, const Eigen::Isometry3d& X) {
  const Eigen::Isometry3f motion = X.cast<float>();
  for (Eigen::Vector3f& p : samples.p) p = motion * p;
  for (Eigen::Vector3f& p : samples.raw) p = motion * p;
  for (Eigen::Vector3f& n : samples.n) n = motion.linear() * n;
  return samples;
}

SurfaceSamples linked_views(SurfaceSamples samples, const Mask& some) {
  std::vector<Eigen::Vector3f> places = samples.raw;
  float widest = 0.0f;
  for (int i = 0; i < samples.size(); ++i) {
    if (some[i]) {
      widest = std::max(widest, samples.cell[i]);
    } else {
      places[i].setConstant(std::numeric_limits<float>::quiet_NaN());
    }
  }
  // Buckets as large as what is sought in them, so that few other samples are looked at.
  const SampleBuckets buckets(places, widest > 0.0f ? widest : 1.0f);
  NearSamples near(buckets, widest);
  std::vector<std::vector<int>> links(static_cast<std::size_t>(samples.size()));
  for (const int i : buckets.in_order()) {
    const float reach = samples.cell[i];
    for (const int j : near.around(places[i])) {
      if (j <= i || samples.view[j] == samples.view[i] ||
          (places[j] - places[i]).squaredNorm() > reach * reach) {
        continue;
      }
      links[i].push_back(j);
      links[j].push_back(i);
    }
  }
  for (std::vector<int>& own : links) std::sort(own.begin(), own.end());
  std::vector<int> first = {0}, neighbours;
  for (int i = 0; i < samples.size(); ++i) {
    const std::span<const int> own = samples.neighbours_of(i);
    neighbours.insert(neighbours.end(), own.begin(), own.end());
    append(links[i], &neighbours);
    first.push_back(static_cast<int>(neighbours.size()));
  }
  samples.first = std::move(first);
  samples.neighbours = std::move(neighbours);
  return samples;
}

}  // namespace quadrille
