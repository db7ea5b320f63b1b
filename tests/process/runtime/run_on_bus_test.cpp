#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

#include "process/runtime/run.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

/// Has itself sent a job with its first status; the job lasts until another status is published.
class SlowNode : public Node {
 public:
  SlowNode(bus::Publish publish, std::atomic<int>* seen_at_work)
      : publish_(std::move(publish)), seen_at_work_(seen_at_work) {}

  std::vector<InChannel> in_channels() const override {
    return {{"--work", "WORK"}, {"--end", "END"}};
  }

  std::optional<Job> receive(const std::string& channel, std::span<const std::byte>) override {
    if (channel == "END") throw std::runtime_error("the end");
    return Job{0, [this] { work_until_status(); }};
  }

  std::string publish_status(const RunState&) override {
    if (statuses_++ == 0) publish_("WORK", kByte);
    return {};
  }

  std::string summary() const override { return ""; }

 private:
  void work_until_status() {
    const int before = statuses_;
    for (int tries = 0; tries < 400 && statuses_ == before; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    *seen_at_work_ = statuses_ - before;
    publish_("END", kByte);
  }

  static inline const std::vector<std::byte> kByte{std::byte{1}};
  const bus::Publish publish_;
  std::atomic<int>* const seen_at_work_;
  std::atomic<int> statuses_{0};
};

/// Has itself sent a message with its first status, whose job is due a while later; no message
/// comes meanwhile.
class PatientNode : public Node {
 public:
  static constexpr Time kWait = std::chrono::milliseconds(120);

  PatientNode(bus::Publish publish, Time* waited) : publish_(std::move(publish)), waited_(waited) {}

  std::vector<InChannel> in_channels() const override {
    return {{"--work", "WORK"}, {"--end", "END"}};
  }
  std::optional<Job> receive(const std::string& channel, std::span<const std::byte>) override {
    if (channel == "END") throw std::runtime_error("the end");
    since_ = now_;
    return std::nullopt;
  }
  std::vector<Job> find_due_jobs(Time now) override {
    now_ = now;
    if (!since_ || now - *since_ < kWait) return {};
    *waited_ = now - *since_;
    since_.reset();
    return {Job{0, [this] { publish_("END", kByte); }}};
  }
  std::string publish_status(const RunState&) override {
    if (!std::exchange(started_, true)) publish_("WORK", kByte);
    return {};
  }
  std::string summary() const override { return ""; }

 private:
  static inline const std::vector<std::byte> kByte{std::byte{1}};
  const bus::Publish publish_;
  Time* const waited_;
  Time now_{};
  std::optional<Time> since_;
  bool started_ = false;
};

TEST_CASE("what waits is done when it is due, though no message comes", "[process]") {
  ProcessArguments arguments;
  arguments.lcm_url = "memq://";
  Node::Time waited{};
  CHECK_THROWS_WITH(run_on_bus(arguments,
                               [&](bus::Publish publish) {
                                 return std::make_unique<PatientNode>(std::move(publish), &waited);
                               }),
                    "the end");
  CHECK(waited >= PatientNode::kWait);
}

TEST_CASE("the status is published while a long job is done", "[process]") {
  ProcessArguments arguments;
  arguments.lcm_url = "memq://";
  std::atomic<int> seen_at_work{0};
  CHECK_THROWS_WITH(run_on_bus(arguments,
                               [&](bus::Publish publish) {
                                 return std::make_unique<SlowNode>(std::move(publish),
                                                                   &seen_at_work);
                               }),
                    "the end");
  CHECK(seen_at_work >= 1);
}

}  // namespace
}  // namespace quadrille
