#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/experiments/plot.hpp"
#include "lab/experiments/table.hpp"

namespace quadrille::experiments {

/// What an experiment is run with.
struct Settings {
  std::uint64_t seed = 1;
  /// A few per cent of the work: shows that it runs, not what it finds.
  bool quick = false;
  /// Told the share that is done, 0 to 1.
  std::function<void(double)> progress = [](double) {};
};

/// What an experiment found.
struct Report {
  /// One sentence each, with the numbers in it.
  std::vector<std::string> findings;
  /// For people.
  std::vector<Table> tables;
  /// All numbers, one observation a row.
  Table data;
  std::vector<Plot> plots;
};

/// An experiment of the paper, or one about what the paper claims.
struct Experiment {
  std::string_view name;
  /// One line: what is measured, and where the paper has it.
  std::string_view about;
  std::function<Report(const Settings&)> run;
};

/// All experiments.
const std::vector<Experiment>& all_experiments();

/// The experiment of a name; nullptr if there is none.
const Experiment* find_experiment(std::string_view name);

/// The report as a Markdown page, headed by the command that makes it again.
std::string to_markdown(const Report& report, const Experiment& experiment,
                        const Settings& settings, std::string_view version);

}  // namespace quadrille::experiments
