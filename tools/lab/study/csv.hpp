#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::study {

/// A row of comma-separated values.
struct CsvRow {
  std::vector<std::string> cells;
  /// Where the next row begins [byte].
  std::size_t end = 0;
};

/// Reads comma-separated values (RFC 4180, with line feeds). What follows the last line feed is no
/// whole row and left out.
std::vector<CsvRow> parse_csv(std::string_view text);

/// One row of cells as parse_csv() reads it, with its line feed.
std::string csv_line(const std::vector<std::string>& cells);

/// A table with named columns.
class CsvTable {
 public:
  /// @param name  of the file, for errors
  /// @throws std::runtime_error if a row has not as many cells as the first, or the columns are not
  ///   those that are asked for
  CsvTable(std::string name, std::string_view text, const std::vector<std::string>& columns);

  std::size_t rows() const { return rows_.size(); }
  /// Where the rows after the first `count` begin [byte].
  std::size_t end_of(std::size_t count) const;
  /// @pre the column is one of those given
  const std::string& cell(std::size_t row, std::string_view column) const;
  /// A whole number; 0 if the cell is empty.
  /// @throws std::runtime_error naming the file and row if it is none
  int count(std::size_t row, std::string_view column) const;
  /// A number.
  /// @throws std::runtime_error likewise
  double number(std::size_t row, std::string_view column) const;

 private:
  std::string place_of(std::size_t row, std::string_view column) const;

  std::string name_;
  std::vector<std::string> columns_;
  std::size_t header_end_ = 0;
  std::vector<CsvRow> rows_;
};

}  // namespace quadrille::study
