#include "quadrille/detector/options.hpp"

#include <algorithm>
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
  // A sphere has only four parameters, so coarse cells, few points and few votes suffice.
  options.sampling.cell *= 2.0;
  options.sampling.stride = 6;
  options.sampling.noise.patches = 100;
  options.search.basis = BasisKind::kSphere;
  options.search.bases = 2;
  options.search.voters = 48;
  options.search.radii = {5.0, 10.0};
  options.search.grow.rounds = 3;
  options.search.grow.families = {Family::kSphere};
  options.aggregate.families = {Family::kSphere};
  // With spheres as the only family, every round surface gets a sphere, and the residual must
  // refuse wrong ones. With all families, richer ones explain such surfaces, and the default
  // refuses none.
  options.aggregate.max_residual = 1.6;
  // More of the wider cells lie at an edge, which lowers the confidence.
  options.aggregate.min_confidence = 0.3;
  return options;
}

}  // namespace quadrille
