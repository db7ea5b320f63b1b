#include "process/runtime/spare_worker.hpp"

#include <optional>

#include "process/runtime/background.hpp"

namespace quadrille {
namespace {

// A spare job waits no longer than this until it is looked for.
constexpr std::chrono::milliseconds kPause(20);

}  // namespace

SpareWorker::SpareWorker(Node& node, int niceness)
    : node_(node), niceness_(niceness), thread_([this] { run(); }) {}

SpareWorker::~SpareWorker() {
  stop_ = true;
  thread_.join();
}

bool SpareWorker::finish(std::chrono::milliseconds patience) {
  stop_ = true;
  return ended_.get_future().wait_for(patience) == std::future_status::ready;
}

void SpareWorker::run() {
  go_to_background(niceness_);
  while (!stop_) {
    if (const std::optional<Job> job = node_.find_spare_job()) {
      node_.work(*job);
    } else {
      std::this_thread::sleep_for(kPause);
    }
  }
  ended_.set_value();
}

}  // namespace quadrille
