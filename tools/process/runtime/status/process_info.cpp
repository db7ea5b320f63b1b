#include "process/runtime/status/process_info.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/hash.hpp"

namespace quadrille {
namespace {

const auto kProcessStart = std::chrono::steady_clock::now();

/// Returns a value of /proc/self/status, in the unit used there; 0 if it is missing.
std::int64_t read_own_status(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.starts_with(key + ":")) return std::stoll(line.substr(key.size() + 1));
  }
  return 0;
}

double cpu_seconds() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::int32_t count_open_files() {
  std::error_code error;
  const std::filesystem::directory_iterator files("/proc/self/fd", error);
  // One of the descriptors is the one with which this folder is read.
  return error ? 0 : static_cast<std::int32_t>(std::distance(begin(files), end(files))) - 1;
}

}  // namespace

void SettingsText::add_channels(const std::vector<NamedChannel>& channels) {
  for (const NamedChannel& channel : channels) add(channel.option, channel.name);
}

void SettingsText::add_frames(const CloudFrames& frames,
                              const std::optional<Eigen::Isometry3d>& X_WK) {
  add("clouds", std::string(to_string(frames.clouds)));
  add("results", std::string(to_string(frames.of_results())));
  if (!X_WK) return;
  for (const double number : X_WK->matrix().reshaped()) add("pose", io::toml_of(number));
}

std::string SettingsText::hash() const { return io::hash_text(text_); }

process_t describe_process(const std::string& settings) {
  constexpr std::int64_t kKilobyte = 1024;
  process_t process;
  process.version = QUADRILLE_VERSION;
  process.settings = settings;
  process.uptime =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - kProcessStart).count();
  process.cpu_time = cpu_seconds();
  process.resident_bytes = kKilobyte * read_own_status("VmRSS");
  process.peak_bytes = kKilobyte * read_own_status("VmHWM");
  process.open_files = count_open_files();
  process.threads = static_cast<std::int32_t>(read_own_status("Threads"));
  return process;
}

}  // namespace quadrille
