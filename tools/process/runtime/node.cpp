#include "process/runtime/node.hpp"

#include <fmt/format.h>

#include <exception>
#include <utility>

namespace quadrille {

std::vector<Job> Node::take(Time now, const std::string& channel,
                            std::span<const std::byte> bytes) {
  std::vector<Job> jobs = find_due_jobs(now);
  if (auto job = receive(channel, bytes)) jobs.push_back(std::move(*job));
  for (Job& job : find_due_jobs(now)) jobs.push_back(std::move(job));
  return jobs;
}

void Node::work(const Job& job) {
  try {
    job.run();
  } catch (const std::exception& error) {
    failure_log_.error(fmt::format("cloud {}: {}", job.cloud_utime, error.what()));
    ++failed_;
    refuse(job, error.what());
  }
}

void Node::refuse(const Job& job, const std::string& why) noexcept {
  if (!job.refuse) return;
  try {
    job.refuse(why);
  } catch (const std::exception& error) {
    static LimitedLog log;
    log.error(
        fmt::format("an answer to cloud {} cannot be sent: {}", job.cloud_utime, error.what()));
  }
}

}  // namespace quadrille
