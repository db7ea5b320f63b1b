#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "io/json/json.hpp"
#include "view/live/question.hpp"
#include "view/plan_choice.hpp"

namespace quadrille::view {

/// A packed scene that several requests may share; null for none.
using Pack = std::shared_ptr<const std::string>;

/// Thrown if a question to the planner is not allowed.
struct NotAllowed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The source of all that the page shows; called from many threads at once.
class Backend {
 public:
  virtual ~Backend() = default;

  /// Describes what can be seen, for the start of the page.
  virtual io::Json session() = 0;
  /// Returns the scene of a cloud of a log, counted from 0; null if there is none.
  /// @throws std::invalid_argument if the choice names something that does not exist
  virtual Pack frame(std::size_t number, const PlanChoice& choice) = 0;
  /// Returns the newest scene of the bus; null before the first one, and for logs.
  virtual Pack newest() { return nullptr; }
  /// Waits until the bus has something newer, or until a timeout.
  /// @return the new version, or the given one if nothing came
  virtual std::uint64_t wait_newer(std::uint64_t version, std::chrono::milliseconds) {
    return version;
  }
  /// Returns what changes without a new scene: rate, latency and losses.
  virtual io::Json status();
  /// Asks the planner on the bus for grasps.
  /// @return the number under which the answer can be fetched
  /// @throws NotAllowed if questions are not allowed
  virtual std::int64_t ask(const Question& question);
  /// Waits for the answer to a question, or until a timeout; null if there is none yet.
  /// @throws std::out_of_range if the question is unknown, or was forgotten because it is too old
  virtual io::Json wait_answer(std::int64_t number, std::chrono::milliseconds timeout);
  /// @throws std::exception if no more data can come
  virtual void check() {}
};

}  // namespace quadrille::view
