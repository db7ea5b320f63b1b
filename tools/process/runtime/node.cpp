#include "process/runtime/node.hpp"

#include <spdlog/spdlog.h>

#include <exception>

namespace quadrille {

void Node::work(const Job& job) {
  try {
    job.run();
  } catch (const std::exception& error) {
    spdlog::error("cloud {}: {}", job.cloud_utime, error.what());
    ++failed_;
  }
}

}  // namespace quadrille
