#include "quadrille/inputs.hpp"

#include <chrono>
#include <optional>
#include <utility>

#include "io/cloud_file.hpp"
#include "io/describe.hpp"
#include "io/file_bytes.hpp"
#include "logs/cloud_log_reader.hpp"
#include "quadrille/bus/clock.hpp"
#include "quadrille/bus/event_log.hpp"
#include "quadrille/detector/rigid_motion.hpp"

namespace quadrille {
namespace {

using Visitor = std::function<void(InputCloud)>;

/// Fills in what is known of a cloud that has been read.
void describe(const std::string& name, std::chrono::steady_clock::time_point start,
              InputCloud* input) {
  input->info = {name, input->cloud.frame, input->cloud.read, bus::ms_since(start),
                 input->X_CK * input->cloud.viewpoint};
}

InputCloud read_cloud_file(const std::string& path, const FrameArguments& frames) {
  const auto start = std::chrono::steady_clock::now();
  InputCloud input;
  input.X_CK = frames.working_frame();
  input.cloud = io::read_cloud(path, input.X_CK.inverse());
  frames.place_viewpoint(&input.cloud);
  describe(path, start, &input);
  return input;
}

/// Reads on to the next cloud of a log; number counts its clouds from 1.
std::optional<InputCloud> read_logged_cloud(logs::CloudLogReader& reader, const std::string& path,
                                            const FrameArguments& frames, int number) {
  const auto start = std::chrono::steady_clock::now();
  auto logged = reader.next();
  if (!logged) return std::nullopt;
  InputCloud input;
  input.X_CK = frames.working_frame();
  input.cloud = moved(std::move(logged->message.cloud), input.X_CK.inverse());
  frames.place_viewpoint(&input.cloud);
  describe(path + "#" + std::to_string(number), start, &input);
  input.channel = logged->channel;
  input.utime = logged->message.utime;
  return input;
}

std::vector<std::string> warnings_about(const logs::CloudLogReader& reader, int clouds) {
  std::vector<std::string> warnings;
  if (reader.defect()) warnings.push_back(*reader.defect());
  for (const bus::RejectReason reason : bus::all_reject_reasons()) {
    const auto count = reader.rejected().of(reason);
    if (count == 0) continue;
    warnings.push_back("refused " + io::count_of(static_cast<std::size_t>(count), "message") +
                       ": " + std::string(to_string(reason)));
  }
  if (clouds == 0) warnings.push_back("holds no cloud; record POINT_CLOUD messages");
  return warnings;
}

std::vector<std::string> visit_log(const std::string& path, const FrameArguments& frames,
                                   const Visitor& visit) {
  logs::CloudLogReader reader(path);
  int clouds = 0;
  while (auto input = read_logged_cloud(reader, path, frames, clouds + 1)) {
    ++clouds;
    visit(std::move(*input));
  }
  return warnings_about(reader, clouds);
}

}  // namespace

bool is_log(const std::string& path) { return path.ends_with(".lcm") || bus::starts_as_log(path); }

std::vector<std::string> for_each_cloud(const std::string& path, const FrameArguments& frames,
                                        const Visitor& visit) {
  if (is_log(path)) return visit_log(path, frames, visit);
  visit(read_cloud_file(path, frames));
  return {};
}

SingleCloud read_single_cloud(const std::string& path, const FrameArguments& frames) {
  std::optional<InputCloud> found;
  auto warnings = for_each_cloud(path, frames, [&](InputCloud input) {
    if (found) throw io::FileError(path, "", "holds more than one cloud; give a single one");
    found = std::move(input);
  });
  if (!found) throw io::FileError(path, "", "holds no cloud; record POINT_CLOUD messages");
  return {std::move(*found), std::move(warnings)};
}

}  // namespace quadrille
