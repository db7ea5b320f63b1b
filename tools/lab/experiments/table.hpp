#pragma once

#include <string>
#include <vector>

namespace quadrille::experiments {

/// A table of words and numbers, as text.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// @throws std::invalid_argument if the row has not one cell a column
  void add(std::vector<std::string> row);
};

/// A number with four significant digits, as tables have it.
std::string number(double value);

/// As Markdown, with the title as a heading where there is one.
std::string to_markdown(const Table& table);

/// As comma-separated values (RFC 4180, with line feeds), without the title.
std::string to_csv(const Table& table);

}  // namespace quadrille::experiments
