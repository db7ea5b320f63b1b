#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/experiments/plot.hpp"
#include "lab/experiments/table.hpp"

namespace quadrille::experiments {

/// The settings of an experiment.
struct Settings {
  std::uint64_t seed = 1;
  /// Does only a few per cent of the work, which shows that the experiment runs, but not what it
  /// finds.
  bool quick = false;
  /// Settings file of the printed pipeline, which only the experiment "printed" reads; empty for
  /// the one that is built in.
  std::string config;
  /// Called with the share of the work that is done, 0 to 1.
  std::function<void(double)> progress = [](double) {};
};

/// The results of an experiment.
struct Report {
  /// One sentence for each finding, including its numbers.
  std::vector<std::string> findings;
  /// Tables for people to read.
  std::vector<Table> tables;
  /// All numbers, one observation per row.
  Table data;
  std::vector<Plot> plots;
};

/// An experiment of the paper, or one that tests a claim of the paper.
struct Experiment {
  std::string_view name;
  /// One line: what is measured, and where the paper describes it.
  std::string_view about;
  std::function<Report(const Settings&)> run;
};

/// All experiments.
const std::vector<Experiment>& all_experiments();

/// Returns the experiment with this name; nullptr if there is none.
const Experiment* find_experiment(std::string_view name);

/// Returns the report as a Markdown page, headed by the command that repeats it.
std::string to_markdown(const Report& report, const Experiment& experiment,
                        const Settings& settings, std::string_view version);

}  // namespace quadrille::experiments
