#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille {

/// A set of numbers 0 … n-1 that is emptied without touching each, for many short walks over the
/// same large graph.
class Marks {
 public:
  explicit Marks(std::size_t size) : round_(size, 0) {}

  void clear() {
    if (++now_ != 0) return;
    std::fill(round_.begin(), round_.end(), std::uint16_t{0});
    now_ = 1;
  }
  /// Returns false if the number was in the set already.
  bool add(int i) {
    // Walks spend most of their time here, so the index is not checked.
    std::uint16_t* const round = round_.data() + i;
    if (*round == now_) return false;
    *round = now_;
    return true;
  }

 private:
  /// Per number, the round in which it was last added; rounds are counted from 1.
  std::vector<std::uint16_t> round_;
  std::uint16_t now_ = 1;
};

}  // namespace quadrille
