#include "lab/study/wilson.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::study {

Share wilson_share(int counted, int of) {
  // The 97.5 % quantile of the normal distribution.
  constexpr double kQuantile = 1.959963984540054;
  if (of <= 0) return {};
  const double n = of, p = counted / n, square = kQuantile * kQuantile;
  const double scale = 1.0 / (1.0 + square / n);
  const double middle = scale * (p + 0.5 * square / n);
  const double half = scale * kQuantile * std::sqrt(p * (1.0 - p) / n + 0.25 * square / (n * n));
  return {p, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace quadrille::study
