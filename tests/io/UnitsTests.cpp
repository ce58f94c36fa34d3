#include "io/Units.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace naocal;

TEST_CASE("units are read and written as products of powers") {
  // Proves both directions, and the refusal of invalid units.
  for (const std::string text : {"1", "rad", "rad/Nm^2", "s/row", "1/rad", "rad/Nm^0.5", "m*rad/s^2", "1/Nm/s"}) {
    const auto unit = parseUnit(text);
    REQUIRE(unit);
    CHECK(formatUnit(*unit) == text);
  }
  CHECK(*parseUnit("rad*rad/rad") == UnitPowers{{"rad", 1}});
  CHECK(*parseUnit("rad/rad") == UnitPowers{});
  CHECK(*parseUnit("1/s^2") == UnitPowers{{"s", -2}});
  for (const char* text :
       {"", "deg", "rad/", "/s", "rad s", "rad//s", "rads", "2*rad", "rad^", "rad^-1", "radrad", "mrad"}) {
    CAPTURE(text);
    CHECK_FALSE(parseUnit(text));
  }
}

TEST_CASE("an angle over what it multiplies has the unit of their quotient") {
  // Proves the units of an expression's coefficients: for a root, a speed, a square, an angle, and a temperature times
  // a torque.
  const UnitPowers angle{{"rad", 1}};
  const auto over = [&](const UnitPowers& other) { return formatUnit(multiplyUnits(angle, other, -1)); };
  CHECK(over(multiplyUnits({}, *parseUnit("Nm"), 0.5)) == "rad/Nm^0.5");
  CHECK(over(*parseUnit("rad/s")) == "s");
  CHECK(over(multiplyUnits(angle, angle)) == "1/rad");
  CHECK(over(angle) == "1");
  CHECK(over(multiplyUnits(*parseUnit("K"), {{"Nm", 1}})) == "rad/K/Nm");
}

TEST_CASE("a value is shown to two significant digits of its standard error") {
  CHECK(formatSize(0.13415, "m") == "134 mm");
  CHECK(formatSize(0.0003, "m") == "0.3 mm");
  CHECK(formatSize(0.00001, "m") == "0.01 mm");
  CHECK(formatSize(0, "m") == "0 mm");
  CHECK(formatSize(0.0174533, "rad") == "1°");
  CHECK(formatEstimate(0.4755, 0.0086) == "0.4755 ± 0.0086");
  CHECK(formatEstimate(8.97, 31) == "9 ± 31");
  CHECK(formatEstimate(-1.27e-5, 4.8e-6) == "-0.0000127 ± 0.0000048");
  CHECK(formatEstimate(-0.0004, 0.12) == "0.00 ± 0.12");
  CHECK(decimalsFor(1e-12) == 9);
  CHECK(decimalsFor(0) == 0);
  CHECK(decimalsFor(std::numeric_limits<double>::infinity()) == 0);
}
