#include "diagnosis/Questioned.hpp"
#include "diagnosis/evidence/CrossValidation.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <string>

namespace naocal {
namespace {

std::vector<std::vector<std::size_t>> everyCandidate(const Questioned& asked) {
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t candidate = 0; candidate < asked.candidateTests.candidates().size(); ++candidate) {
    all.push_back({candidate});
  }
  return all;
}

} // namespace

TEST_CASE("the best of many candidates seems to lower the error of unseen poses, one chosen without them does not",
          "[slow]") {
  // Proves, for robots without hidden effects, that selection outside the folds is biased and that it is done inside.
  int lured = 0;
  double before = 0, next = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Questioned asked{simulatedSet(12, seed), false};
    const auto held = crossValidate(asked.candidateTests, asked.model, {}, everyCandidate(asked));
    REQUIRE(held);
    lured += *std::min_element(held->afterPx.begin(), held->afterPx.end()) < held->beforePx;
    CHECK(held->chosenPx == held->beforePx); // no effect was selected
    before += held->beforePx;
    next += held->nextPx;
  }
  CHECK(lured >= 5);
  CHECK(next > 0.999 * before);
}

TEST_CASE("an effect that is there is chosen in every fold, one that is not is no better than its choice", "[slow]") {
  // Proves that an effect of the model is removed and selected anew in every fold: it is selected if it explains the
  // misfit; otherwise the folds choose another.
  CaptureSet set = simulatedSet(16, 3);
  const auto knee = std::find(set.jointNames.begin(), set.jointNames.end(), "LKneePitch") - set.jointNames.begin();
  for (Capture& capture : set.captures) {
    capture.joints.measured[static_cast<std::size_t>(knee)] *= 0.99;
  }
  const std::string gain = "encoderGain@LKneePitch", nonsense = "encoderGain@HeadYaw";
  const Questioned without{set, false}, with{set, false, {gain}}, wrong{set, false, {nonsense}};
  const auto base = crossValidate(without.candidateTests, without.model, {}, {}),
             right = crossValidate(with.candidateTests, with.model, {gain}, {}),
             other = crossValidate(wrong.candidateTests, wrong.model, {nonsense}, {});
  REQUIRE((base && right && other));
  CHECK(right->chosenPx < 0.8 * base->chosenPx);
  CHECK(right->chosenPx == Approx(right->beforePx).epsilon(0.02));
  CHECK(base->nextPx == Approx(right->chosenPx).epsilon(0.1)); // up to linearisation
  CHECK(other->chosenPx < 0.9 * other->beforePx);              // the folds select the knee's gain instead
}

TEST_CASE("what only priors tell is not fitted to the poses that are to be predicted", "[slow]") {
  // Proves that the held-out error exceeds the fit's, also with an effect that depends on torques. That effect adds the
  // offsets of the arms, which images hardly determine; fitted to the held-out fold, they would absorb its encoder
  // noise and bring the held-out error below the noise floor.
  const Questioned asked{simulatedSet(16, 3), false, {"elasticity@LKneePitch"}};
  const auto held = crossValidate(asked.candidateTests, asked.model, {}, {});
  REQUIRE(held);
  CHECK(held->beforePx > asked.fit.rmsPx);
  CHECK(held->beforePx < 2 * asked.fit.rmsPx);
}

TEST_CASE("where a single pose says how two stances lie, it is not predicted from the others", "[slow]") {
  // Proves that a placement direction which the other folds do not determine is estimated from the held-out fold
  // itself. Otherwise its error would be hundreds of pixels, which no effect could reduce.
  CaptureSet set = simulatedSet(16, 3);
  std::map<std::string, int> seen;
  for (const Capture& capture : set.captures) {
    for (const BoardCorners& board : *capture.corners) {
      ++seen[board.board];
    }
  }
  REQUIRE(seen.size() > 1);
  const auto most = [](const auto& a, const auto& b) { return a.second < b.second; };
  const std::string other = std::max_element(seen.begin(), seen.end(), most)->first;
  std::map<std::string, std::size_t> poses;
  for (const Capture& capture : set.captures) {
    poses.emplace(capture.pose, poses.size());
  }
  const Questioned whole{set, false};
  const auto tied = crossValidate(whole.candidateTests, whole.model, {}, {});
  const auto seesBoth = [&](std::size_t pose) {
    bool own = false, others = false;
    for (const Capture& capture : set.captures) {
      for (const BoardCorners& board : *capture.corners) {
        (board.board == other ? own : others) |= poses.at(capture.pose) == pose;
      }
    }
    return own && others;
  };
  std::size_t bridge = 0;
  while (!seesBoth(bridge)) {
    ++bridge;
  }
  set.stances.push_back({1, SupportFoot::left, {}});
  for (Capture& capture : set.captures) {
    const std::size_t pose = poses.at(capture.pose);
    capture.stance = pose == bridge || pose % 2 == 1 ? 1 : 0;
    std::erase_if(*capture.corners, [&](const BoardCorners& board) {
      return pose != bridge && (board.board == other) != (capture.stance == 1);
    });
  }
  const Questioned asked{set, false};
  const auto held = crossValidate(asked.candidateTests, asked.model, {}, {});
  REQUIRE((tied && held));
  CHECK(held->beforePx < 2 * tied->beforePx);
}

TEST_CASE("of one pose none is left to try the fit on") {
  // Proves that the fit's error is not reported as a held-out error if there is only one pose.
  const Questioned asked{simulatedSet(1, 3), false};
  CHECK_FALSE(crossValidate(asked.candidateTests, asked.model, {}, {}));
}

} // namespace naocal
