#include "recordings/table/CsvTable.hpp"

#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace naocal;

TEST_CASE("a table is read as spreadsheets, scripts and numpy write it") {
  // Proves separators, quotes, the byte order mark, decimal commas, line ends and numpy's comment.
  struct Case {
    std::string text;
    double second; // number in row 0, column "b c"
  };
  const std::vector<Case> all{
      {"a,b c\n1,2.5\n3,4\n", 2.5},
      {"\xef\xbb\xbf"
       "a,b c\r\n1,2.5\r\n3,4",
       2.5},
      {"a;b c\n1;2,5\n3;4\n", 2.5},
      {"a\tb c\n1\t-2.5e-3\n3\t4\n", -2.5e-3},
      {"\"a\",\"b c\"\n\"1\",\" +2.5 \"\n3,4\n", 2.5},
      {"# a,b c\n1,2.5\n3,4\n", 2.5},
      {"a\t\"b c\"\r\n1\t2.5\r\n3\t4\r\n", 2.5},
  };
  for (const Case& each : all) {
    CAPTURE(each.text);
    const CsvTable table{each.text, "log.csv"};
    CHECK(table.names() == std::vector<std::string>{"a", "b c"});
    REQUIRE(table.rows() == 2);
    CHECK(table.number(0, table.column("b c")) == each.second);
    CHECK(table.number(1, 1) == 4);
  }
  const CsvTable gaps{"a,b\n,nan\n1,NaN\n", "log.csv"};
  CHECK_FALSE(gaps.number(0, 0));
  CHECK_FALSE(gaps.number(0, 1));
  CHECK_FALSE(gaps.number(1, 1));
}

TEST_CASE("a table's cells may be separated by spaces") {
  // Proves one or several spaces, at the ends of lines, too, decimal commas, and that spaces within the names of a
  // table with another separator, or in a single column's, separate nothing.
  for (const char* const text : {"t q_0 q_1\n0 1.5 2\n1 2.5 3\n", "  t   q_0 q_1 \r\n 0  1,5 2\r\n1 2,5   3 \r\n"}) {
    const CsvTable table{text, "log.txt"};
    CHECK(table.names() == std::vector<std::string>{"t", "q_0", "q_1"});
    REQUIRE(table.rows() == 2);
    CHECK(table.number(0, 1) == 1.5);
    CHECK(table.number(1, 2) == 3);
  }
  CHECK(CsvTable{"joint 1\n0.5\n", "log.csv"}.names() == std::vector<std::string>{"joint 1"});
  CHECK(CsvTable{"joint 1,joint 2\n0.5,0.6\n", "log.csv"}.names().size() == 2);
}

TEST_CASE("a name of two columns is refused only where it is used") {
  const CsvTable table{"q,d,d\n1,2,3\n", "log.csv"};
  CHECK(table.isUnique("q"));
  CHECK_FALSE(table.isUnique("d"));
  CHECK(table.column("q") == 0);
  CHECK_THROWS_WITH(table.column("d"), Catch::Contains("row 1: expected one column \"d\", as it is used, found two"));
}

TEST_CASE("a table is in UTF-8 or else in ISO 8859-1") {
  // Proves names and cells of both; of the second also what is nearly UTF-8, a surrogate and a letter that is cut off.
  CHECK(CsvTable{"q1 [°],n\n1,ä\n", "log.csv"}.names().at(0) == "q1 [°]");
  CHECK(CsvTable{"q1 [°],n\n1,ä\n", "log.csv"}.text(0, 1) == "ä");
  CHECK(CsvTable{"q1 [\xb0],n\n1,\xe4\n", "log.csv"}.names().at(0) == "q1 [°]");
  CHECK(CsvTable{"q1 [\xb0],n\n1,\xe4\n", "log.csv"}.text(0, 1) == "ä");
  CHECK(CsvTable{"a\n\xed\xa0\x80\n", "log.csv"}.text(0, 0) == "í\xc2\xa0\xc2\x80");
  CHECK(CsvTable{"a\nb\xc2", "log.csv"}.text(0, 0) == "bÂ");
}

TEST_CASE("a table that is none is refused with row, expected and found") {
  struct Broken {
    std::string text, sentence;
  };
  const std::vector<Broken> all{
      {"", "expected a row of column names, found an empty file"},
      {"a,b\n", "expected readings below the row of names, found none"},
      {"a,,c\n1,2,3\n", "log.csv, row 1: expected a name for column 2, found none"},
      {"a,b\n1,2\n3\n", "log.csv, row 3: expected 2 cells, as there are columns, found 1"},
      {"a,b\n1,2,3\n", "log.csv, row 2: expected 2 cells, as there are columns, found 3"},
      {"a,b\n1,\"2\n", "found broken quotes"},
      {"a,b\n1,2\"3\n", "found broken quotes"},
  };
  for (const Broken& broken : all) {
    CAPTURE(broken.text);
    CHECK_THROWS_WITH((CsvTable{broken.text, "log.csv"}),
                      Catch::StartsWith("log.csv") && Catch::Contains(broken.sentence));
  }
  const CsvTable table{"shoulder,elbow\n1,two\n1e400,0x10\n", "log.csv"};
  CHECK_THROWS_WITH(table.number(0, 1), "log.csv, row 2, column \"elbow\": expected a number, found \"two\"");
  CHECK_THROWS_AS(table.number(1, 0), InputError);
  CHECK_THROWS_AS(table.number(1, 1), InputError);
  CHECK_THROWS_WITH(table.column("elbw"), Catch::Contains("expected a column \"elbw\", found elbow"));
}
