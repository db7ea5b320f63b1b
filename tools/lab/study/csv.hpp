#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::study {

/// A row of comma-separated values.
struct CsvRow {
  std::vector<std::string> cells;
  /// Offset at which the next row begins [byte].
  std::size_t end = 0;
};

/// Parses comma-separated values (RFC 4180, with line feeds). Text after the last line feed is an
/// incomplete row and is left out.
std::vector<CsvRow> parse_csv(std::string_view text);

/// Formats one row of cells as parse_csv() reads it, with its line feed.
std::string csv_line(const std::vector<std::string>& cells);

/// A table with named columns.
class CsvTable {
 public:
  /// @param name  name of the file, for errors
  /// @throws std::runtime_error if a row does not have as many cells as the first, or the columns
  ///   are not the given ones
  CsvTable(std::string name, std::string_view text, const std::vector<std::string>& columns);

  std::size_t rows() const { return rows_.size(); }
  /// Offset of the end of the first `count` rows [byte].
  std::size_t end_of(std::size_t count) const;
  /// @pre the column is one of those given
  const std::string& cell(std::size_t row, std::string_view column) const;
  /// Returns a whole number; 0 if the cell is empty.
  /// @throws std::runtime_error naming the file and row if it is not a whole number
  int count(std::size_t row, std::string_view column) const;
  /// Returns a number.
  /// @throws std::runtime_error naming the file and row if it is not a number
  double number(std::size_t row, std::string_view column) const;

 private:
  std::string place_of(std::size_t row, std::string_view column) const;

  std::string name_;
  std::vector<std::string> columns_;
  std::size_t header_end_ = 0;
  std::vector<CsvRow> rows_;
};

}  // namespace quadrille::study
