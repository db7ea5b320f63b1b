#include "cli/describe_program.hpp"

#include <CLI/CLI.hpp>

#include "cli/completion.hpp"
#include "cli/manual_page.hpp"

namespace quadrille {

std::string describe_program(const CLI::App& app, const std::string& how,
                             const std::vector<std::string>& words) {
  if (how == "manual") return manual_page(app, words);
  if (how != "complete") return "";
  std::string text;
  for (const Completion& found : complete(app, words)) {
    text += found.word + "\t" + found.meaning + "\n";
  }
  return text;
}

}  // namespace quadrille
