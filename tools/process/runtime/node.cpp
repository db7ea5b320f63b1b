#include "process/runtime/node.hpp"

#include <fmt/format.h>

#include <exception>

#include "process/runtime/logging.hpp"

namespace quadrille {

void Node::work(const Job& job) {
  try {
    job.run();
  } catch (const std::exception& error) {
    log_error(fmt::format("cloud {}: {}", job.cloud_utime, error.what()));
    ++failed_;
    if (job.refuse) job.refuse(error.what());
  }
}

}  // namespace quadrille
