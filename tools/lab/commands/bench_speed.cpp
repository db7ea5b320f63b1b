#include "lab/commands/bench_speed.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "io/new_file.hpp"
#include "lab/bench/report.hpp"

namespace quadrille {
namespace {

std::vector<bench::CloudSpeed> measured(bench::SpeedOptions options) {
  ProgressLine line;
  options.frames.progress = [&](double share) { line.show(share); };
  return bench::measure_speed(options);
}

void store(const std::vector<bench::CloudSpeed>& clouds, const std::string& path) {
  io::write_file(path, to_json(bench::baseline_of(clouds, bench::built_by())));
  print("stored in " + path + "\n");
}

/// @throws std::runtime_error if detection in a set needs too many instructions
void judge(const std::vector<bench::SpeedSet>& sets) {
  for (const bench::SpeedSet& set : sets) {
    if (!set.is_too_slow()) continue;
    throw std::runtime_error(
        fmt::format("detection in {} takes {:.1f} % more instructions than the baseline; find out "
                    "why, or renew "
                    "the baseline with --store",
                    set.name, 100.0 * set.total.change()));
  }
}

}  // namespace

void run_speed(bench::SpeedOptions options, const SpeedFiles& files) {
  const bench::SpeedBaseline baseline =
      files.baseline.empty() ? bench::own_baseline() : bench::read_baseline(files.baseline);
  const std::string why_not = bench::why_not_counted(options.programs);
  if (!why_not.empty()) {
    const std::string warning = "no instructions are counted: " + why_not;
    if (!files.store.empty()) throw std::runtime_error(warning);
    print_warnings("bench", {warning});
  }
  const std::vector<bench::CloudSpeed> clouds = measured(std::move(options));
  const std::vector<bench::SpeedSet> sets = bench::summarise(clouds, baseline, bench::built_by());
  print(to_markdown(bench::to_table(sets)));
  for (const bench::SpeedSet& set : sets) {
    if (set.not_compared.empty()) continue;
    print_warnings("bench", {set.name + " is compared with nothing: " + set.not_compared});
  }
  if (files.store.empty()) {
    judge(sets);
  } else {
    store(clouds, files.store);
  }
}

}  // namespace quadrille
