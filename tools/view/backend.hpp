#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "io/json.hpp"

namespace quadrille::view {

/// A packed scene that several requests may hold at once; null for none.
using Pack = std::shared_ptr<const std::string>;

/// What the page shows comes from here; called from many threads at once.
class Backend {
 public:
  virtual ~Backend() = default;

  /// What there is to see, for the start of the page.
  virtual io::Json session() = 0;
  /// The scene of a cloud of a log, counted from 0; null if there is none.
  virtual Pack frame(std::size_t number) = 0;
  /// The newest scene of the bus; null before the first, and for logs.
  virtual Pack newest() { return nullptr; }
  /// Waits until the bus has something newer, and at most so long.
  /// @return the new version, or the same one
  virtual std::uint64_t wait_newer(std::uint64_t version, std::chrono::milliseconds) {
    return version;
  }
  /// What changes without a new scene: rate, latency and losses.
  virtual io::Json status();
  /// @throws std::exception if nothing can come any more
  virtual void check() {}
};

}  // namespace quadrille::view
