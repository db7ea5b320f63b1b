#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace quadrille::bus {

/// A slot for one item between a thread that receives and a thread that works: the newest wins.
/// There may be several slots, each with a name, which are emptied in the order in which they were
/// filled. Beside them a short queue for items that no other replaces. Where both hold something
/// they are taken in turns.
template <class T>
class Mailbox {
 public:
  /// Puts an item into the slot of that name; one that was not yet taken is dropped and counted.
  /// There are as many slots as names: their number is for the caller to bound.
  void put(T item, const std::string& slot = "") {
    // An item may be large: the old one dies after the lock is given back.
    std::optional<T> dropped;
    {
      const std::lock_guard lock(mutex_);
      const auto found = std::find_if(slots_.begin(), slots_.end(),
                                      [&](const auto& filled) { return filled.first == slot; });
      if (found == slots_.end()) {
        slots_.emplace_back(slot, std::move(item));
      } else {
        dropped = std::exchange(found->second, std::move(item));
        ++superseded_;
      }
    }
    filled_.notify_one();
  }

  /// Items that may wait in the queue.
  static constexpr std::size_t kMaxQueued = 64;

  /// Puts an item into the queue; false, and nothing done, if that is full.
  bool queue(T item) {
    {
      const std::lock_guard lock(mutex_);
      if (queue_.size() >= kMaxQueued) return false;
      queue_.push_back(std::move(item));
    }
    filled_.notify_one();
    return true;
  }

  /// Takes an item, waiting for one for as long as the timeout; nullopt if none came.
  std::optional<T> take(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    filled_.wait_for(lock, timeout, [this] { return !slots_.empty() || !queue_.empty(); });
    if (!queue_.empty() && !(from_queue_ && !slots_.empty())) {
      from_queue_ = true;
      T item = std::move(queue_.front());
      queue_.pop_front();
      return item;
    }
    from_queue_ = false;
    if (slots_.empty()) return std::nullopt;
    T item = std::move(slots_.front().second);
    slots_.pop_front();
    return item;
  }

  /// Items dropped for a newer one so far.
  std::int64_t superseded() const {
    const std::lock_guard lock(mutex_);
    return superseded_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  /// Those that are filled, by name.
  std::deque<std::pair<std::string, T>> slots_;
  std::deque<T> queue_;
  /// Whether the last item came from the queue.
  bool from_queue_ = false;
  std::int64_t superseded_ = 0;
};

}  // namespace quadrille::bus
