#include "cli/completion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

const CLI::App* find_command(const CLI::App& app, const std::string& name) {
  const auto commands =
      app.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
  return commands.empty() ? nullptr : commands.front();
}

const CLI::Option* find_option(const CLI::App& app, const std::string& name) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->nonpositional() && option->check_name(name)) return option;
  }
  return nullptr;
}

/// The state of a command line at its last word: the command, and the option that waits for its
/// value.
struct Place {
  const CLI::App* command;
  const CLI::Option* waiting = nullptr;
};

Place walk(const CLI::App& app, const std::vector<std::string>& words) {
  Place place{&app};
  for (const std::string& word : words) {
    if (place.waiting != nullptr) {
      place.waiting = nullptr;
    } else if (const CLI::Option* option = find_option(*place.command, word)) {
      if (option->get_items_expected_max() > 0) place.waiting = option;
    } else if (const CLI::App* command = find_command(*place.command, word)) {
      place.command = command;
    }
  }
  return place;
}

/// Returns the words that an option accepts, from the name of its value: `one|two`, `TYPE,...`.
std::vector<std::string> values_of(const CLI::Option& option) {
  std::string type = option.get_type_name();
  std::vector<std::string> values;
  if (type.starts_with("TYPE")) {
    for (const QuadricType each : all_quadric_types()) {
      if (!is_imaginary(each)) values.emplace_back(to_string(each));
    }
    return values;
  }
  if (const auto list = type.find(','); list != std::string::npos) type.resize(list);
  const bool is_choice =
      type.find('|') != std::string::npos &&
      type.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-|") == std::string::npos;
  return is_choice ? CLI::detail::split(type, '|') : values;
}

std::vector<Completion> complete_value(const CLI::Option& option, const std::string& word) {
  // In a list, the last element is completed.
  const std::string before = word.substr(0, word.rfind(',') + 1);
  std::vector<Completion> all;
  for (const std::string& value : values_of(option)) all.push_back({before + value, ""});
  return all;
}

std::vector<Completion> complete_option(const CLI::App& command) {
  std::vector<Completion> all;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->nonpositional() || option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) {
      all.push_back({"--" + name, option->get_description()});
    }
  }
  return all;
}

std::vector<Completion> complete_command(const CLI::App& command) {
  std::vector<Completion> all;
  for (const CLI::App* each : command.get_subcommands({})) {
    all.push_back({each->get_name(), each->get_description()});
  }
  return all;
}

}  // namespace

std::vector<Completion> complete(const CLI::App& app, std::vector<std::string> words) {
  const std::string last = words.empty() ? "" : words.back();
  if (!words.empty()) words.pop_back();
  const Place place = walk(app, words);
  std::vector<Completion> all = place.waiting != nullptr ? complete_value(*place.waiting, last)
                                : last.starts_with('-')  ? complete_option(*place.command)
                                                         : complete_command(*place.command);
  std::erase_if(all, [&](const Completion& each) { return !each.word.starts_with(last); });
  return all;
}

}  // namespace quadrille
