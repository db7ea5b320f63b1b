#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "io/new_file.hpp"
#include "log/event_log.hpp"
#include "process/runtime/logging.hpp"
#include "process/runtime/run.hpp"
#include "process/runtime/status/stats_file.hpp"
#include "process/runtime/watch/channel_census.hpp"
#include "quadrille/detector/printable.hpp"
#include "run/stop.hpp"

namespace quadrille {
namespace {

/// Refuses to copy results of earlier runs among new ones, because readers could not tell them
/// apart.
void check_unmixed(const std::string& path, const std::vector<OutChannel>& channels) {
  ChannelCensus census;
  bus::LogReader log(path);
  while (const auto event = log.next()) census.add(event->channel);
  const std::string taken = census.find_taken(channels);
  if (taken.empty()) return;
  throw std::runtime_error(
      fmt::format("{}: with --copy-input its events would be mixed with new results on {}; publish "
                  "on another channel with the option named, or leave out --copy-input",
                  path, taken));
}

/// Runs a node through a log. The output log appears under its name once it is complete.
class LogRun {
 public:
  LogRun(const ProcessArguments& arguments, const NodeMaker& make_node)
      : arguments_(arguments),
        log_(arguments.in_log),
        file_(arguments.out_log),
        out_(file_.path(), arguments.out_log),
        stats_(arguments.stats_file),
        node_(make_node([this](const std::string& channel, std::span<const std::byte> bytes) {
          publish(channel, bytes);
        })) {}

  void run() {
    if (arguments_.copy_input) check_unmixed(arguments_.in_log, node_->out_channels());
    while (!bus::stop_requested()) {
      const auto event = log_.next();
      if (!event) break;
      handle(*event);
    }
    // Nothing more will come, so all jobs that still wait are due.
    work(node_->find_due_jobs(Node::Time::max()));
    const std::string incomplete = save();
    if (!incomplete.empty()) throw std::runtime_error(incomplete);
    log_info(arguments_.in_log + ": " + node_->summary());
    if (node_->failed() == 0) return;
    throw std::runtime_error(fmt::format("{}: {} of its clouds failed; the records above say why",
                                         arguments_.in_log, node_->failed()));
  }

 private:
  /// Writes the status, and gives the output log its name.
  /// @return a message if the log holds less than it should
  std::string save() {
    const std::string incomplete = describe_incomplete();
    stats_.write(node_->publish_status({.warnings = find_warnings(incomplete)}));
    const std::lock_guard lock(writing_);
    closed_ = true;
    check_written();
    out_.flush();
    file_.commit();
    return incomplete;
  }

  /// Publishes a message. A failure to write ends the whole run, not just the job.
  void publish(const std::string& channel, std::span<const std::byte> bytes) {
    const std::lock_guard lock(writing_);
    if (closed_) return;
    try {
      out_.write(utime_, channel, bytes);
    } catch (const std::runtime_error&) {
      if (!write_error_) write_error_ = std::current_exception();
    }
  }

  void check_written() const {
    if (write_error_) std::rethrow_exception(write_error_);
  }

  void handle(const bus::LogReader::Event& event) {
    ++done_;
    utime_ = event.utime;
    census_.add(event.channel);
    if (arguments_.copy_input) out_.write(event.utime, event.channel, event.bytes);
    work(node_->take(Node::Time(event.utime), event.channel, event.bytes));
  }

  void work(const std::vector<Job>& jobs) {
    for (const Job& job : jobs) work(job);
    check_written();
  }

  /// Does a job in a separate thread, so that a stop need not wait for its end.
  void work(const Job& job) {
    auto done = std::async(std::launch::async, [&] { node_->work(job); });
    const auto ends_within = [&](std::chrono::milliseconds time) {
      return done.wait_for(time) == std::future_status::ready;
    };
    while (!ends_within(std::chrono::milliseconds(50))) {
      if (bus::stop_requested() && !ends_within(kStopPatience)) give_up();
    }
    done.get();
  }

  /// Ends the process while a job is running, which then writes no more.
  [[noreturn]] void give_up() {
    --done_;
    log_error(save());
    std::_Exit(1);
  }

  /// Describes a replay that did not reach the end of the log; empty if it did.
  std::string describe_incomplete() const {
    if (done_ >= log_.survey().events) return "";
    const std::string why =
        bus::stop_requested()
            ? fmt::format("stopped before the end of the log, after {} of {} events", done_,
                          log_.survey().events)
            : fmt::format("{}; wait until it is written",
                          log_.survey().defect.value_or("cut short"));
    return fmt::format("{}: {}; {} holds only what came of these", arguments_.in_log, why,
                       arguments_.out_log);
  }

  /// Returns warnings, and logs those about the log. For a log that was not read to its end, only
  /// that is reported, since missing events mean nothing then.
  std::vector<std::string> find_warnings(const std::string& incomplete) const {
    if (!incomplete.empty()) return {printable(incomplete, kMaxLine)};
    std::vector<std::string> warnings =
        census_.find_missing(node_->in_channels(), arguments_.channel_prefix);
    if (log_.survey().defect) warnings.push_back(*log_.survey().defect);
    for (std::string& oddity : node_->find_oddities()) warnings.push_back(std::move(oddity));
    for (std::string& warning : warnings) {
      warning = printable(arguments_.in_log, kMaxPath) + ": " + printable(warning, kMaxLine);
      log_warning(warning);
    }
    return warnings;
  }

  const ProcessArguments& arguments_;
  bus::LogReader log_;
  io::NewFile file_;
  bus::LogWriter out_;
  StatsFile stats_;
  std::mutex writing_;
  bool closed_ = false;
  std::exception_ptr write_error_;
  // Results carry the time of the event that they answer. It is the same in every run, and not
  // later than that of any event copied after them.
  std::int64_t utime_ = 0;
  std::unique_ptr<Node> node_;
  ChannelCensus census_;
  std::int64_t done_ = 0;
};

}  // namespace

void run_on_log(const ProcessArguments& arguments, const NodeMaker& make_node) {
  bus::check_different_files(arguments.in_log, arguments.out_log);
  LogRun(arguments, make_node).run();
}

}  // namespace quadrille
