#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <list>
#include <mutex>
#include <optional>
#include <utility>

#include "quadrille/detector/parallel_for.hpp"

namespace quadrille {

/// Takes steps that depend on each other with the help of several threads; see take_steps().
template <class Steps>
class AheadOfSteps {
 public:
  AheadOfSteps(Steps* steps, int threads)
      : steps_(*steps), max_begun_(Steps::kTriesPerThread * static_cast<std::size_t>(threads)) {}

  /// Tries steps and takes them until none is left. Each thread calls this once.
  void work() {
    std::unique_lock lock(mutex_);
    try {
      work(&lock);
    } catch (...) {
      if (!lock.owns_lock()) lock.lock();
      end();
      throw;
    }
  }

 private:
  /// A step that was tried, or is being tried.
  struct Begun {
    int step = 0;
    /// Number of changes of the state before the try.
    std::size_t changes = 0;
    /// Nothing while the step is being tried.
    std::optional<typename Steps::Outcome> outcome;
  };

  void work(std::unique_lock<std::mutex>* lock) {
    typename Steps::Scratch scratch = steps_.scratch();
    typename Steps::State state = steps_.state();
    std::size_t state_at = changes_;
    while (!ended_) {
      Begun* const begun = take_and_begin();
      if (!begun) {
        if (!ended_) turn_.wait(*lock);
        continue;
      }
      if (state_at != changes_) state = steps_.state();
      state_at = changes_;
      lock->unlock();
      auto outcome = steps_.attempt(begun->step, state, &scratch);
      lock->lock();
      begun->outcome = std::move(outcome);
      turn_.notify_all();
    }
  }

  /// Takes all steps whose turn it is and that were tried, and begins another one; null if there is
  /// none to begin at present.
  Begun* take_and_begin() {
    while (const std::optional<int> first = steps_.first()) {
      const auto begun = std::find_if(begun_.begin(), begun_.end(),
                                      [&](const Begun& b) { return b.step == *first; });
      if (begun == begun_.end()) return begin_another();
      if (!begun->outcome) return may_begin() ? begin_another() : nullptr;
      if (begun->changes != changes_ && !steps_.holds(*first, *begun->outcome)) {
        begun->outcome.reset();
        begun->changes = changes_;
        return &*begun;
      }
      if (steps_.take(*first, std::move(*begun->outcome))) ++changes_;
      begun_.erase(begun);
    }
    end();
    return nullptr;
  }

  bool may_begin() {
    if (begun_.size() < max_begun_) return true;
    begun_.remove_if([&](const Begun& b) { return b.outcome && !steps_.is_left(b.step); });
    return begun_.size() < max_begun_;
  }

  Begun* begin_another() {
    const std::optional<int> step = steps_.begin_next();
    return step ? &begun_.emplace_back(Begun{*step, changes_, std::nullopt}) : nullptr;
  }

  void end() {
    ended_ = true;
    turn_.notify_all();
  }

  Steps& steps_;
  const std::size_t max_begun_;
  std::mutex mutex_;
  /// Is told when a step has been tried, and when no more will be.
  std::condition_variable turn_;
  std::list<Begun> begun_;
  std::size_t changes_ = 0;
  bool ended_ = false;
};

/// Takes steps one after the other, each of which may change a state on which the later ones
/// depend. Several threads also try the steps to come, as if those before them changed nothing. An
/// outcome that may not hold any more when it is the step's turn is thrown away, and the step is
/// tried again; so the result has the same bits for any number of threads.
///
/// Steps has:
///   State                 what steps look at and change; each thread has a copy of it
///   state()               the present state
///   Scratch, scratch()    memory that a thread uses for its tries
///   Outcome               of a try
///   kTriesPerThread       number of tries that may wait for earlier steps: enough that no thread
///                         is idle during a long try, few enough that not many are in vain
///   first()               the step whose turn it is, nullopt if none is left
///   begin_next()          a step to try that this did not return before, nullopt if there is none
///                         at present; it is the first() one if that was not returned before
///   is_left(step)         false if the step will not be the first any more
///   attempt(step, state, scratch)  tries a step; threads call it at once for different steps
///   holds(step, outcome)  true only if a try at an earlier state would have the same outcome now
///   take(step, outcome)   takes a step, which then is no longer the first; returns true if that
///                         changed the state
template <class Steps>
void take_steps(Steps* steps, int threads) {
  if (threads > 1) {
    AheadOfSteps<Steps> ahead(steps, threads);
    parallel_for(threads, threads, [&](int) { ahead.work(); });
    return;
  }
  typename Steps::Scratch scratch = steps->scratch();
  while (const std::optional<int> step = steps->first()) {
    steps->take(*step, steps->attempt(*step, steps->state(), &scratch));
  }
}

}  // namespace quadrille
