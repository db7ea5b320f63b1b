#include "cli/unit_option.hpp"

#include <CLI/CLI.hpp>

#include "cli/choice_option.hpp"

namespace quadrille {

void add_unit_option(CLI::App& app, double& unit) {
  add_choice_option(app, "--unit", unit, Choices<double>{{"m", 1.0}, {"mm", 1e-3}},
                    "Unit of the clouds' coordinates, metres (default) or millimetres");
}

}  // namespace quadrille
