#include "quadrille/inputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "io/cloud_file.hpp"
#include "io/file_bytes.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/log_input.hpp"

namespace quadrille {
namespace {

InputCloud read_cloud_file(const std::string& path, const FrameArguments& frames) {
  const auto start = std::chrono::steady_clock::now();
  InputCloud input;
  input.X_CK = frames.working_frame();
  input.cloud = io::read_cloud(path, frames.from_file());
  frames.place_viewpoint(&input.cloud);
  input.describe(path, start);
  return input;
}

}  // namespace

bool may_be_several(const std::vector<std::string>& paths) {
  return paths.size() > 1 || is_log(paths.front());
}

std::vector<std::string> for_each_cloud(const std::string& path, const InputArguments& arguments,
                                        const std::function<void(InputCloud)>& visit) {
  const std::optional<LogName> log = log_name_of(path);
  if (log) return visit_log(*log, arguments, visit);
  visit(read_cloud_file(path, arguments.frames));
  return {};
}

void ReadingResult::check() const {
  if (failed == 0) return;
  throw std::runtime_error(fmt::format("{} of {} inputs could not be read", failed, inputs));
}

ReadingResult for_each_input(
    const std::vector<std::string>& paths, const InputArguments& arguments,
    const std::function<void(const std::string& path, InputCloud)>& visit) {
  ReadingResult result;
  result.inputs = paths.size();
  std::optional<ProgressLine> line;
  if (isatty(STDOUT_FILENO) == 0 && may_be_several(paths)) line.emplace();
  for (std::size_t n = 0; n < paths.size(); ++n) {
    const std::string& path = paths[n];
    const auto visit_and_count = [&](InputCloud input) {
      const double share =
          (static_cast<double>(n) + input.share) / static_cast<double>(paths.size());
      if (line) line->wipe();
      try {
        visit(path, std::move(input));
      } catch (const io::FileError& error) {
        // The error is not the input's fault, so it ends the command.
        throw std::runtime_error(error.what());
      }
      ++result.clouds;
      if (line) line->show(share);
    };
    try {
      print_warnings(path, for_each_cloud(path, arguments.of_input(n), visit_and_count));
    } catch (const io::FileError& error) {
      if (paths.size() == 1) throw;
      // An input that cannot be read must not prevent the others from being processed.
      fmt::print(stderr, "quadrille: {}\n", printable(error.what(), kMaxLine));
      ++result.failed;
    }
  }
  return result;
}

SingleCloud read_single_cloud(const std::string& path, const InputArguments& arguments) {
  std::optional<InputCloud> found;
  auto warnings = for_each_cloud(path, arguments, [&](InputCloud input) {
    if (found) {
      const bool mixed = found->channel != input.channel;
      throw io::FileError(
          path, "",
          fmt::format("holds more than one cloud{}; name one by its number, such as {}#1",
                      mixed ? fmt::format(", on {} and {}", printable(found->channel),
                                          printable(input.channel))
                            : "",
                      path));
    }
    found = std::move(input);
  });
  if (!found) throw io::FileError(path, "", warnings.back());
  return {std::move(*found), std::move(warnings)};
}

}  // namespace quadrille
