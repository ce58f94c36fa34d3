#include "io/InputError.hpp"
#include "setups/LeftOut.hpp"
#include "setups/Mending.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

Capture capture(int id, const std::string& pose) {
  Capture result;
  result.id = id;
  result.pose = pose;
  result.corners = std::vector<BoardCorners>{{"A", {1}, {{1, 2}}}, {"B", {1}, {{3, 4}}}};
  result.points.emplace_back();
  return result;
}

std::vector<CaptureSet> twoSets() {
  std::vector<CaptureSet> sets(2);
  sets[0].name = "one";
  sets[1].name = "two";
  for (CaptureSet& set : sets) {
    set.boards.resize(2);
    set.boards[0].id = "A";
    set.boards[1].id = "B";
    set.captures = {capture(7, "P1"), capture(8, "P1"), capture(9, "P2")};
  }
  return sets;
}

/// Corners and readings that are left, by set and capture: "22/2x/.." with x for none.
std::string left(const std::vector<CaptureSet>& sets) {
  std::string text;
  for (const CaptureSet& set : sets) {
    for (const Capture& capture : set.captures) {
      text += std::to_string(capture.corners->size()) + (capture.points.empty() ? "x" : "");
    }
    text += "/";
  }
  return text;
}

} // namespace

TEST_CASE("captures, poses and boards are left out, of all sets or of one") {
  // Proves what each label takes away, and that captures stay in their order.
  const auto leftAfter = [](const std::string& label) {
    std::vector<CaptureSet> sets = twoSets();
    leaveOut(label, sets);
    return left(sets);
  };
  CHECK(leftAfter("leftOut@capture:8") == "20x2/20x2/");
  CHECK(leftAfter("leftOut@capture:two/8") == "222/20x2/");
  CHECK(leftAfter("leftOut@capture:7,9") == "0x20x/0x20x/");
  CHECK(leftAfter("leftOut@pose:one/P1") == "0x0x2/222/");
  CHECK(leftAfter("leftOut@board:B") == "111/111/");
  CHECK(leaveOutLabel("two/8") == "leftOut@capture:two/8");
}

TEST_CASE("what is not there cannot be left out") {
  const auto refusal = [](const std::string& label) {
    std::vector<CaptureSet> sets = twoSets();
    try {
      leaveOut(label, sets);
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"left out"};
  };
  CHECK(refusal("leftOut@capture:77") ==
        "'leftOut@capture:77': '77' is no capture of these captures; near it are 7, 8, 9");
  CHECK(refusal("leftOut@pose:P1,P7").find("'P7' is no pose") != std::string::npos);
  CHECK(refusal("leftOut@pose:P1,P2").find("all captures are left out") != std::string::npos);
  CHECK(refusal("leftOut@knee").ends_with("expected leftOut@capture:ID, leftOut@pose:NAME or leftOut@board:ID"));
}

TEST_CASE("labels of what is left out are told from effects") {
  CHECK(isSetUp("leftOut@capture:8"));
  CHECK_FALSE(isSetUp("elasticity@LKneePitch"));
  CHECK(joinLabels({"leftOut@capture:8", "9", "backlash@x"}) ==
        std::vector<std::string>{"leftOut@capture:8,9", "backlash@x"});
}

} // namespace naocal
