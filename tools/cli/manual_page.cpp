#include "cli/manual_page.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace quadrille {
namespace {

/// Escapes text so that roff shows it literally.
std::string escape(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    if (c == '\\') {
      roff += "\\e";
    } else if (c == '-') {
      roff += "\\-";
    } else {
      roff += c == '\n' ? ' ' : c;
    }
  }
  const bool is_request = roff.starts_with('.') || roff.starts_with('\'');
  return (is_request ? "\\&" : "") + roff;
}

std::string bold(const std::string& text) { return "\\fB" + escape(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escape(text) + "\\fR"; }

std::string sentence(const std::string& text) {
  return escape(text) + (text.ends_with('.') ? "" : ".");
}

/// Returns what a program or command does, in the one line by which manual pages are searched.
std::string purpose(const CLI::App& command) {
  const std::string about = command.get_description();
  std::string line = about.substr(0, about.find_first_of(".;:"));
  if (!line.empty()) line[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(line[0])));
  return escape(line);
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Splits the type of an option into the name of its value and the remarks that CLI11 adds, such as
/// its range.
std::pair<std::string, std::string> split_type(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  const std::string type = option.get_type_name();
  const auto colon = type.find(':');
  if (colon == std::string::npos) return {type, ""};
  return {type.substr(0, colon), type.substr(colon + 1)};
}

std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(bold(option->get_name()));
  std::sort(names.begin(), names.end());
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string positional_name(const CLI::Option& option) {
  return option.get_name(true) + (option.get_items_expected_max() > 1 ? "..." : "");
}

std::string heading_of(const CLI::Option& option) {
  if (option.get_positional()) return italic(positional_name(option));
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back(bold("-" + name));
  for (const std::string& name : option.get_lnames()) names.push_back(bold("--" + name));
  const std::string value = split_type(option).first;
  return fmt::format("{}{}", fmt::join(names, ", "), value.empty() ? "" : " " + italic(value));
}

std::string describe(const CLI::Option& option) {
  std::string text = sentence(option.get_description());
  if (const std::string more = split_type(option).second; !more.empty()) {
    text += " " + escape(upper(more.substr(0, 1)) + more.substr(1)) + ".";
  }
  if (!option.get_default_str().empty()) {
    text += " Default: " + bold(option.get_default_str()) + ".";
  }
  if (!option.get_needs().empty()) text += " Only with " + names_of(option.get_needs()) + ".";
  if (!option.get_excludes().empty()) text += " Not with " + names_of(option.get_excludes()) + ".";
  return fmt::format(".TP\n{}\n{}\n", heading_of(option), text);
}

std::string list_options(const CLI::App& command, const char* title, bool positional) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() == positional && !option->get_group().empty()) {
      text += describe(*option);
    }
  }
  return text.empty() ? "" : fmt::format(".SH {}\n{}", title, text);
}

std::string list_commands(const CLI::App& command, const std::string& page) {
  std::string text;
  for (const CLI::App* each : command.get_subcommands({})) {
    text += fmt::format(".TP\n{}(1)\n{}\n", bold(page + "-" + each->get_name()),
                        sentence(each->get_description()));
  }
  return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

std::string synopsis(const CLI::App& command, const std::string& name) {
  std::string text = fmt::format(".SH SYNOPSIS\n{} [{}]", bold(name), italic("OPTION..."));
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const std::string word = italic(positional_name(*option));
    text += option->get_required() ? " " + word : " [" + word + "]";
  }
  if (!command.get_subcommands({}).empty()) text += " " + italic("COMMAND");
  return text + "\n";
}

constexpr const char* kExitStatus =
    ".SH \"EXIT STATUS\"\n0 done; 1 failed, and one line on stderr says what and how to mend it;\n"
    "2 wrong usage.\n";

constexpr const char* kOtherPages =
    "\\fBquadrille\\-detector\\fR(1), \\fBquadrille\\-grasp\\-planner\\fR(1)\n";

}  // namespace

std::string manual_page(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  std::string name = app.get_name();
  for (const std::string& word : words) {
    const CLI::App* wanted = nullptr;
    for (const CLI::App* each : command->get_subcommands({})) {
      if (each->get_name() == word) wanted = each;
    }
    if (wanted == nullptr) throw std::invalid_argument("no command '" + word + "'");
    command = wanted;
    name += " " + word;
  }
  std::string page = name;
  std::replace(page.begin(), page.end(), ' ', '-');
  std::string text = fmt::format(".TH {} 1 @DATE@ \"quadrille {}\" \"User Commands\"\n",
                                 escape(upper(page)), QUADRILLE_VERSION);
  text += fmt::format(".SH NAME\n{} \\- {}\n", escape(page), purpose(*command));
  text += synopsis(*command, name);
  text += fmt::format(".SH DESCRIPTION\n{}\n", sentence(command->get_description()));
  text += list_commands(*command, page);
  text += list_options(*command, "ARGUMENTS", true);
  text += list_options(*command, "OPTIONS", false);
  text += kExitStatus;
  text += ".SH \"SEE ALSO\"\n" + (page != "quadrille" ? bold("quadrille") + "(1)\n" : kOtherPages);
  return text;
}

}  // namespace quadrille
