#pragma once

namespace quadrille::study {

/// A share of counted things, and the range of its true value.
struct Share {
  double value = 0.0, low = 0.0, high = 1.0;
};

/// Computes a share with its 95 % interval after Wilson (1927). If a share p̂ of n things counts,
/// and z = 1.96, the interval is (p̂ + z²/2n ± z √(p̂(1 − p̂)/n + z²/4n²)) / (1 + z²/n). For n = 0
/// the share is 0 and the interval 0 to 1.
Share wilson_share(int counted, int of);

}  // namespace quadrille::study
