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

}  // namespace quadrille
