#include "lab/experiments/experiment.hpp"

#include <fmt/format.h>

#include "lab/experiments/experiments.hpp"

namespace quadrille::experiments {

const std::vector<Experiment>& all_experiments() {
  static const std::vector<Experiment> all = {
      {"fitting", "errors and time of all fits under noise (figure 5)", run_fitting},
      {"minimal", "time of the minimal solve against SVD of the 12x10 system (theorem 3)",
       run_minimal},
      {"lambda", "the distribution of the null-space parameter beside atan (figure 4b)",
       run_lambda},
      {"basis", "2, 3, 4 and 9 points a basis in contaminated neighbourhoods (figure 6b)",
       run_basis},
      {"sampling", "2, 3, 4 and 9 points in the whole detector over the sampling rate (figure 6b)",
       run_sampling},
      {"triplets", "how often the search draws a basis again (section 5)", run_triplets},
      {"printed", "the printed pipeline, and the steps from it to the detector (section 4)",
       run_printed},
      {"spheres", "errors of spheres in generated scenes, time of spheres alone (figure 6c)",
       run_spheres},
      {"cylinders", "cylinders in clutter: generated bins (after table 2)", run_cylinders},
      {"deviations", "published standard deviations beside the errors, in generated scenes",
       run_deviations},
      {"growth", "time and memory over the size of fused clouds", run_growth},
      {"votes", "the votes for λ of one basis (figure 3)", run_votes},
      {"pencil", "the surfaces of one pencil over λ (figure 4a)", run_pencil},
      {"examples", "fits to noisy points, drawn (figure 5B)", run_examples},
      {"planes", "quadrics in place of planes that are not taken out first (figure 9)", run_planes},
      {"balls", "eight generated sequences of moving balls (table 1)", run_balls},
      {"objects", "any quadric along each of five objects in 35 cluttered scenes (section 5)",
       run_objects},
      {"sequence", "errors of a ball in a sequence of real scans (figure 6c, table 1)",
       run_sequence},
  };
  return all;
}

const Experiment* find_experiment(std::string_view name) {
  for (const Experiment& experiment : all_experiments()) {
    if (experiment.name == name) return &experiment;
  }
  return nullptr;
}

std::string to_markdown(const Report& report, const Experiment& experiment,
                        const Settings& settings, std::string_view version) {
  const std::string command =
      fmt::format("quadrille experiment {} --seed {}{}{}", experiment.name, settings.seed,
                  settings.quick ? " --quick" : "",
                  settings.config.empty() ? "" : " --config " + settings.config);
  std::string text = fmt::format("# {}: {}\n\n", experiment.name, experiment.about);
  text += fmt::format("quadrille {}, seed {}: `{}`. ", version, settings.seed, command);
  text += "Times depend on the machine; all else is the same each time.\n\n";
  if (!report.plots.empty()) text += fmt::format("![{0}]({0}.svg)\n\n", experiment.name);
  for (const std::string& finding : report.findings) text += fmt::format("- {}\n", finding);
  for (const Table& table : report.tables) text += fmt::format("\n{}", to_markdown(table));
  return text;
}

}  // namespace quadrille::experiments
