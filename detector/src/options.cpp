#include "quadrille/detector/options.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace quadrille {

std::vector<Word<QuadricType>> words_of(QuadricType) {
  std::vector<Word<QuadricType>> words;
  for (const QuadricType type : all_quadric_types()) {
    if (is_imaginary(type) || type == QuadricType::kCoincidentPlanes) continue;
    words.push_back({to_string(type), type});
  }
  return words;
}

void DetectorOptions::check() const {
  check_ranges(*this);
  if (search.radii.empty()) throw std::invalid_argument("search.radii: must not be empty");
  if (!std::is_sorted(search.radii.begin(), search.radii.end())) {
    throw std::invalid_argument("search.radii: must ascend");
  }
  if (search.grow.families.empty()) {
    throw std::invalid_argument("search.grow.families: must not be empty");
  }
}

DetectorOptions sphere_preset() {
  DetectorOptions options;
  options.only = {QuadricType::kSphere};
  // A sphere has only four parameters, so cells of twice the area and few hypotheses suffice.
  options.sampling.cell *= std::numbers::sqrt2;
  options.sampling.noise.patches = 100;
  options.search.basis = BasisKind::kSphere;
  options.search.bases = 2;
  options.search.voters = 48;
  options.search.radii = {6.0, 12.0};
  options.search.grow.rounds = 6;
  // A sample averages over twice the points, so it is worth twice the measurements.
  options.aggregate.effective_share *= 2.0;
  // Of the false spheres in generated scenes, two thirds have less confidence than this, and next
  // to none of the true ones.
  options.aggregate.min_confidence = 0.7;
  // All families stay on offer while surfaces grow and are fitted, because a sphere that has no
  // rival lies along a part of every cone, ellipsoid and hyperboloid.
  return options;
}

}  // namespace quadrille
