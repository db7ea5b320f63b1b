#include "lab/bench/instructions.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "io/file_bytes.hpp"
#include "io/ply/ply.hpp"
#include "lab/bench/run_process.hpp"
#include "lab/bench/scratch_folder.hpp"

namespace quadrille::bench {
namespace {

std::string program_in(const std::string& programs) { return programs + "/quadrille-counted"; }

std::string text_of(const std::string& path) {
  const std::vector<std::byte> bytes = io::read_file(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Calls `work` with each line, without its end.
template <class Work>
void for_each_line(std::string_view text, const Work& work) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    work(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// The number of instructions of each profile. Callgrind ends each with a line "totals: N".
std::vector<std::uint64_t> totals_in(std::string_view profiles) {
  constexpr std::string_view kTotals = "totals: ";
  std::vector<std::uint64_t> totals;
  for_each_line(profiles, [&](std::string_view line) {
    if (!line.starts_with(kTotals)) return;
    std::uint64_t total = 0;
    std::from_chars(line.data() + kTotals.size(), line.data() + line.size(), total);
    totals.push_back(total);
  });
  return totals;
}

void add(std::string_view part, std::uint64_t count, Instructions* counts) {
  const auto known = std::find_if(counts->begin(), counts->end(),
                                  [&](const auto& entry) { return entry.first == part; });
  if (known != counts->end()) {
    known->second += count;
  } else {
    counts->emplace_back(part, count);
  }
}

}  // namespace

std::uint64_t instructions_of(const Instructions& counts, std::string_view part) {
  for (const auto& [name, count] : counts) {
    if (name == part) return count;
  }
  return 0;
}

std::string why_not_counted(const std::string& programs) {
  if (!std::filesystem::exists(program_in(programs))) {
    return program_in(programs) + " is not built (target quadrille-counted)";
  }
  if (!run_process({"valgrind", "-q", "--tool=none", "--log-file=/dev/null", "/bin/true"})) {
    return "valgrind is not installed (tools/setup --ci), or does not run here";
  }
  return "";
}

Instructions count_instructions(const std::string& programs, const PointCloud& cloud,
                                const std::string& config) {
  const ScratchFolder folder;
  const std::string ply = folder.file("cloud.ply"), names = folder.file("names.txt"),
                    profiles = folder.file("profiles"), log = folder.file("log.txt");
  io::write_ply(ply, cloud);
  if (!run_process({"valgrind", "-q", "--tool=callgrind", "--combine-dumps=yes",
                    "--dump-before=quadrille_part_ended", "--callgrind-out-file=" + profiles,
                    "--log-file=" + log, program_in(programs), ply, config, names})) {
    throw std::runtime_error("valgrind: failed on " + program_in(programs) + ": " +
                             (std::filesystem::exists(log) ? text_of(log) : "it left no log"));
  }
  return parse_counts(text_of(names), text_of(profiles));
}

Instructions parse_counts(std::string_view names, std::string_view profiles) {
  const std::vector<std::uint64_t> totals = totals_in(profiles);
  Instructions counts;
  std::size_t part = 0;
  for_each_line(names, [&](std::string_view name) {
    if (part < totals.size()) add(name, totals[part], &counts);
    ++part;
  });
  if (part == 0 || totals.size() != part + 1) {
    throw std::runtime_error("callgrind: wrote " + std::to_string(totals.size()) +
                             " profiles where " + std::to_string(part) + " parts ended");
  }
  return counts;
}

}  // namespace quadrille::bench
