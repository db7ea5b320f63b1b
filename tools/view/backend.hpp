#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "io/json.hpp"
#include "view/plan_choice.hpp"
#include "view/question.hpp"

namespace quadrille::view {

/// A packed scene that several requests may hold at once; null for none.
using Pack = std::shared_ptr<const std::string>;

/// Thrown for what may not be asked here.
struct NotAllowed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the page shows comes from here; called from many threads at once.
class Backend {
 public:
  virtual ~Backend() = default;

  /// What there is to see, for the start of the page.
  virtual io::Json session() = 0;
  /// The scene of a cloud of a log, counted from 0; null if there is none.
  /// @throws std::invalid_argument if what is chosen does not exist
  virtual Pack frame(std::size_t number, const PlanChoice& choice) = 0;
  /// The newest scene of the bus; null before the first, and for logs.
  virtual Pack newest() { return nullptr; }
  /// Waits until the bus has something newer, and at most so long.
  /// @return the new version, or the same one
  virtual std::uint64_t wait_newer(std::uint64_t version, std::chrono::milliseconds) {
    return version;
  }
  /// What changes without a new scene: rate, latency and losses.
  virtual io::Json status();
  /// Asks the planner on the bus for grasps.
  /// @return the number under which the answer will be
  /// @throws NotAllowed if nothing may be asked
  virtual std::int64_t ask(const Question& question);
  /// Waits for the answer to a question, and at most so long; null while there is none.
  /// @throws std::out_of_range if that was not asked, or so long ago that it is forgotten
  virtual io::Json wait_answer(std::int64_t number, std::chrono::milliseconds timeout);
  /// @throws std::exception if nothing can come any more
  virtual void check() {}
};

}  // namespace quadrille::view
