#include "process/runtime/status/exposition.hpp"

#include <fmt/format.h>

#include <utility>

namespace quadrille {
namespace {

constexpr double kSecondsPerMs = 1e-3;

/// Quotes the value of a label as the format requires.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\\' || c == '"') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else {
      out += c;
    }
  }
  return out + '"';
}

}  // namespace

Exposition::Exposition(std::string prefix, const Labels& labels) : prefix_(std::move(prefix)) {
  for (const auto& [name, value] : labels) {
    labels_ += fmt::format("{}{}={}", labels_.empty() ? "" : ",", name, quoted(value));
  }
}

void Exposition::start(const std::string& name, const std::string& help, const char* type) {
  text_ += fmt::format("# HELP {0}_{1} {2}\n# TYPE {0}_{1} {3}\n", prefix_, name, help, type);
}

void Exposition::add_sample(const std::string& name, const std::string& labels, double value) {
  const char* comma = labels_.empty() || labels.empty() ? "" : ",";
  const std::string all = fmt::format("{}{}{}", labels_, comma, labels);
  text_ += fmt::format("{}_{}{} {}\n", prefix_, name, all.empty() ? "" : fmt::format("{{{}}}", all),
                       value);
}

void Exposition::add_counter(const std::string& name, const std::string& help, std::int64_t value) {
  start(name + "_total", help, "counter");
  add_sample(name + "_total", "", static_cast<double>(value));
}

void Exposition::add_gauge(const std::string& name, const std::string& help, double value) {
  start(name, help, "gauge");
  add_sample(name, "", value);
}

void Exposition::add_counters(const std::string& name, const std::string& help,
                              const std::vector<count_t>& counts) {
  start(name + "_total", help, "counter");
  for (const count_t& entry : counts) {
    add_sample(name + "_total", "reason=" + quoted(entry.name), static_cast<double>(entry.count));
  }
}

void Exposition::add_stages(const std::vector<stage_t>& stages) {
  start("stage_seconds", "Time that a stage takes; quantiles over the last 1000.", "summary");
  for (const stage_t& stage : stages) {
    const std::string label = "stage=" + quoted(stage.name);
    const std::pair<const char*, double> quantiles[] = {
        {"0.5", stage.p50}, {"0.9", stage.p90}, {"0.99", stage.p99}, {"1", stage.max}};
    for (const auto& [quantile, ms] : quantiles) {
      add_sample("stage_seconds", fmt::format("{},quantile=\"{}\"", label, quantile),
                 kSecondsPerMs * ms);
    }
    add_sample("stage_seconds_sum", label, kSecondsPerMs * stage.total);
    add_sample("stage_seconds_count", label, static_cast<double>(stage.count));
  }
}

void Exposition::add_pose_age(double ms) {
  if (ms < 0.0) return;
  add_gauge("pose_age_seconds", "Time between the last cloud and the nearest pose about it.",
            kSecondsPerMs * ms);
}

void Exposition::add_process(const process_t& process) {
  start("info", "Version, and a hash of the settings.", "gauge");
  add_sample(
      "info",
      fmt::format("version={},settings={}", quoted(process.version), quoted(process.settings)),
      1.0);
  add_gauge("uptime_seconds", "Time since the start of the process.", process.uptime);
  start("cpu_seconds_total", "Processor time of all threads.", "counter");
  add_sample("cpu_seconds_total", "", process.cpu_time);
  add_gauge("resident_memory_bytes", "Memory in use.", static_cast<double>(process.resident_bytes));
  add_gauge("peak_memory_bytes", "The most memory in use so far.",
            static_cast<double>(process.peak_bytes));
  add_gauge("open_files", "File descriptors.", process.open_files);
  add_gauge("threads", "Threads.", process.threads);
}

void Exposition::add_transport(const transport_t& transport) {
  add_gauge("largest_message_bytes", "The largest message so far.",
            static_cast<double>(transport.largest_message));
  add_gauge("receive_buffer_bytes", "Receive buffer that the kernel grants.",
            static_cast<double>(transport.receive_buffer));
  if (transport.dropped_datagrams >= 0) {
    add_counter("dropped_datagrams", "Datagrams lost because the receive buffer was full.",
                transport.dropped_datagrams);
    add_counter("filtered_datagrams", "Datagrams that the filter of the process refused.",
                transport.filtered_datagrams);
    add_counter("unclear_datagrams", "Datagrams lost or refused: not told apart.",
                transport.unclear_datagrams);
  }
  add_counter("dropped_messages", "Messages driven out by newer ones before they were read.",
              transport.dropped_messages);
}

}  // namespace quadrille
