#include "lab/study/csv.hpp"

#include <stdexcept>

#include "lcmtypes/contains.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::study;

TEST_CASE("cells come back as they were written, whatever they hold", "[study]") {
  const std::vector<std::string> cells = {"a", "", "b,c", "say \"x\"", "two\nlines", "\"", " d "};
  const std::string text = csv_line(cells) + csv_line({"last"});
  const std::vector<CsvRow> rows = parse_csv(text);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].cells == cells);
  CHECK(rows[0].end == csv_line(cells).size());
  CHECK(rows[1].cells == std::vector<std::string>{"last"});
  CHECK(rows[1].end == text.size());
}

TEST_CASE("a row that a stop cut short is no row", "[study][hostile]") {
  CHECK(parse_csv("").empty());
  CHECK(parse_csv("a,b").empty());
  CHECK(parse_csv("a,\"b\n").empty());
  CHECK(parse_csv("a,b\nc,").size() == 1);
}

TEST_CASE("a table tells which cell is wrong", "[study][hostile]") {
  const CsvTable table("t.csv", "n,x\n3,0.5\n,\nfour,1e\n", {"n", "x"});
  REQUIRE(table.rows() == 3);
  CHECK(table.count(0, "n") == 3);
  CHECK(table.number(0, "x") == 0.5);
  CHECK(table.count(1, "n") == 0);
  CHECK(table.end_of(0) == 4);
  CHECK(table.end_of(1) == 10);
  CHECK_THROWS_WITH(table.count(2, "n"), test::contains("t.csv: row 3, column n: 'four'"));
  CHECK_THROWS_WITH(table.number(2, "x"), test::contains("row 3, column x: '1e' is no number"));
  CHECK_THROWS_WITH(CsvTable("t.csv", "n,y\n", {"n", "x"}), test::contains("line 1"));
  CHECK_THROWS_WITH(CsvTable("t.csv", "n,x\n1\n", {"n", "x"}),
                    test::contains("row 1: has 1 cells"));
}
