#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quadrille::experiments {

/// Formats a number with four significant digits, as used in tables.
std::string number(double value);

/// A table of words and numbers, as text.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// @throws std::invalid_argument if the row does not have one cell per column
  void add(std::vector<std::string> row);

  /// Adds a row of texts and of numbers, which number() formats.
  template <class... Cells>
  void row(const Cells&... cells) {
    add({text_of(cells)...});
  }

 private:
  static std::string text_of(std::string_view text) { return std::string(text); }
  static std::string text_of(double value) { return number(value); }
};

/// Formats the table as Markdown, with the title as a heading if there is one.
std::string to_markdown(const Table& table);

/// Formats the table as comma-separated values (RFC 4180, with line feeds), without the title.
std::string to_csv(const Table& table);

}  // namespace quadrille::experiments
