#include <fmt/format.h>

#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "io/planner/config.hpp"
#include "io/settings/setting_text.hpp"

namespace quadrille::io {
namespace {

/// Formats a text as comment lines of at most 100 bytes.
std::string comment(const std::string& text) {
  constexpr std::size_t kWidth = 100;
  std::string lines, line = "#";
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > kWidth) {
      lines += line + "\n";
      line.resize(1);
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

/// Returns "0.1 to 100 m", "one of …"; empty if the field's type implies its range.
template <class Field>
std::string range_of(const Setting& setting) {
  if constexpr (Choice<Field>) {
    return "one of " + list_words<Field>();
  } else if constexpr (List<Field>) {
    const std::string each = range_of<typename ElementOf<Field>::type>(setting);
    return "each " + each;
  } else if constexpr (std::is_same_v<Field, double> || std::is_same_v<Field, int>) {
    const std::string unit = *setting.unit == '\0' ? "" : fmt::format(" {}", setting.unit);
    constexpr auto kFormat = std::is_same_v<Field, int> ? "{:d} to {:d}{}" : "{:g} to {:g}{}";
    return fmt::format(kFormat, static_cast<Field>(setting.min), static_cast<Field>(setting.max),
                       unit);
  } else {
    return "";
  }
}

/// Prints options, with a header where each table begins.
class Printer {
 public:
  template <class Options>
  void print(const Options& options) {
    const Options defaults;
    std::vector<std::string> default_values;
    Options::visit(defaults, [&](const auto& field, const Setting&) {
      default_values.push_back(toml_of(field));
    });
    std::size_t row = 0;
    Options::visit(options, [&](const auto& field, const Setting& setting) {
      using Field = std::remove_cvref_t<decltype(field)>;
      const std::string range = range_of<Field>(setting);
      begin(setting.name);
      text_ += comment(setting.why);
      text_ += comment((range.empty() ? "" : range + "; ") + "default " + default_values[row++]);
      text_ += fmt::format("{} = {}\n", key_of(setting.name), toml_of(field));
    });
  }

  const std::string& text() const { return text_; }

 private:
  static std::string key_of(const std::string& name) { return name.substr(name.rfind('.') + 1); }

  void begin(const std::string& name) {
    text_ += "\n";
    const std::size_t end = name.rfind('.');
    const std::string table = end == std::string::npos ? "" : name.substr(0, end);
    if (table == table_) return;
    table_ = table;
    text_ += fmt::format("[{}]\n", table);
  }

  std::string text_, table_;
};

}  // namespace

std::string to_toml(const Config& config) {
  Printer printer;
  printer.print(config.detector);
  printer.print(config.track);
  printer.print(config.planner);
  return comment(
             "Settings of quadrille and of its processes, which --config reads. A setting "
             "that is left out has its default.") +
         printer.text();
}

}  // namespace quadrille::io
