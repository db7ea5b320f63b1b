#include "base/try_ahead.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// Takes the largest of some numbers. A try finds a remainder by the sum of all that were taken
/// before, some of which count and then lower the other numbers.
class Draws {
 public:
  using State = std::vector<int>;
  struct Scratch {};
  using Outcome = int;
  static constexpr std::size_t kTriesPerThread = 4;

  explicit Draws(int size) : begun_(static_cast<std::size_t>(size), false) {
    RandomStream random(3, 0);
    for (int k = 0; k < size; ++k) value_.push_back(1 + random.below(1000));
  }

  const State& state() const { return counted_; }
  Scratch scratch() const { return {}; }
  std::optional<int> first() const {
    const auto best = std::max_element(value_.begin(), value_.end());
    if (best == value_.end() || *best <= 0) return std::nullopt;
    return static_cast<int>(best - value_.begin());
  }
  std::optional<int> begin_next() {
    std::optional<int> next = first();
    for (int k = 0; next && begun_[*next] && k < static_cast<int>(value_.size()); ++k) {
      if (value_[k] > 0 && !begun_[k]) next = k;
    }
    if (!next || begun_[*next]) return std::nullopt;
    begun_[*next] = true;
    return next;
  }
  bool is_left(int step) const { return value_[step] > 0; }
  int attempt(int step, const State& counted, Scratch* /*none*/) const {
    if (step == fails_at) throw std::runtime_error("step " + std::to_string(step));
    // Steps that take different times come to an end in another order.
    if (step % 3 == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    return remainder(step, counted);
  }
  bool holds(int step, int outcome) const { return remainder(step, counted_) == outcome; }
  bool take(int step, int outcome) {
    outcomes.push_back(outcome);
    value_[step] = 0;
    if (outcome % 4 != 0) return false;
    counted_.push_back(outcome);
    for (std::size_t k = 0; k < value_.size(); ++k) {
      if (value_[k] > 0 && (static_cast<int>(k) + outcome) % 5 == 0) value_[k] /= 2;
    }
    return true;
  }

  std::vector<int> outcomes;
  int fails_at = -1;

 private:
  static int remainder(int step, const State& counted) {
    int sum = step;
    for (const int k : counted) sum = (7 * sum + k) % 1009;
    return sum;
  }

  std::vector<int> value_;
  std::vector<bool> begun_;
  State counted_;
};

std::vector<int> outcomes(int threads) {
  Draws draws(200);
  take_steps(&draws, threads);
  return draws.outcomes;
}

}  // namespace

TEST_CASE("steps that are tried ahead have the outcomes that they have one by one",
          "[parallel][determinism]") {
  const std::vector<int> one = outcomes(1);
  CHECK(one.size() > 100);
  for (const int threads : {2, 3, 8}) CHECK(outcomes(threads) == one);
}

TEST_CASE("no steps end at once", "[parallel][degenerate]") {
  for (const int threads : {1, 2}) {
    Draws draws(0);
    take_steps(&draws, threads);
    CHECK(draws.outcomes.empty());
  }
}

TEST_CASE("the exception of a try ends all threads and is rethrown", "[parallel]") {
  for (const int threads : {1, 2, 8}) {
    Draws draws(200);
    draws.fails_at = 17;
    CHECK_THROWS_WITH(take_steps(&draws, threads), "step 17");
  }
}
