#include "writer/machines/WorkcellQuestion.hpp"
#include "writer/machines/WorkcellVisibility.hpp"

#include <catch2/catch.hpp>
#include <map>

namespace blind {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

double boardShare(const Workcell& cell, const WorkcellSession& session) {
  std::size_t seen = 0;
  for (const WorkcellReading& reading : session) {
    seen += reading.seen.size();
  }
  return static_cast<double>(seen) / static_cast<double>(session.size() * cell.points.size());
}

/// Draws the readings' and the joints' errors anew, from the distributions of staging.
void redrawJoints(const Workcell& cell, const WorkcellPlan& plan, WorkcellSession& session, RandomStream& chance) {
  const double half = scatterOf(plan).pose;
  const VectorXd scale = jointScale(*cell.machine);
  std::map<int, VectorXd> ofPose;
  for (std::size_t reading = 0; reading < session.size(); ++reading) {
    WorkcellReading& one = session[reading];
    if (reading > 0 && session[reading - 1].approachNumber == one.approachNumber) {
      one.unread = session[reading - 1].unread;
      one.stuck = session[reading - 1].stuck;
      continue;
    }
    auto [sticking, isNew] = ofPose.try_emplace(one.pose, VectorXd::Zero(scale.size()));
    for (Index i = 0; isNew && i < scale.size(); ++i) {
      sticking->second[i] = scale[i] * chance.normal(half);
    }
    for (Index i = 0; i < scale.size(); ++i) {
      one.unread[i] = scale[i] * chance.uniformOfSigma(plan.encoderStep / std::sqrt(12.0));
      one.stuck[i] = sticking->second[i] + scale[i] * chance.normal(half);
    }
  }
}

} // namespace

TEST_CASE("the noncentrality of a machine's flaw is the variance of the score, by drawing noise") {
  // Proves derivatives, noise model and sizing together, for cameras, a tracker and repeated approaches, by Monte
  // Carlo: without the flaw the score d^T M Sigma^-1 r has mean 0 and variance lambda.
  for (const Witness witness : {Witness::cameraBeside, Witness::trackedPoints, Witness::footAndHead}) {
    RandomStream chance{static_cast<std::uint64_t>(witness), "lambda of machines"};
    WorkcellQuestion question;
    do {
      question = drawWorkcellQuestion({"catalogue", "encoderEccentricity", 40, witness, 15}, chance);
    } while (question.plan.scatter == 0 || question.plan.samples == 1);
    REQUIRE(question.hidden);
    CHECK(question.hidden->noncentrality == Approx(40).epsilon(0.03));
    Workcell sound = question.cell;
    sound.flaws = MachineFlaws{question.machine->joints.size()};
    WorkcellSession quiet = question.session;
    for (WorkcellReading& reading : quiet) {
      reading.unread.setZero();
      reading.stuck.setZero();
    }
    const VectorXd expected = stackMeasurements(sound, quiet);
    const VectorXd change = stackMeasurements(question.cell, quiet) - expected;
    const ProjectedProduct visibility = workcellVisibility(sound, quiet, question.plan);
    constexpr int draws = 200;
    double sum = 0, squares = 0;
    for (int draw = 0; draw < draws; ++draw) {
      redrawJoints(sound, question.plan, quiet, chance);
      VectorXd residual = stackMeasurements(sound, quiet) - expected;
      for (double& value : residual) {
        value += chance.normal(question.plan.sigma);
      }
      const double score = visibility.product(change, residual);
      sum += score;
      squares += score * score;
    }
    const double lambda = visibility.product(change, change);
    CHECK(lambda == Approx(40).epsilon(0.05));
    CHECK(std::abs(sum / draws) < 4 * std::sqrt(lambda / draws));
    CHECK(squares / draws == Approx(lambda).epsilon(0.4)); // four standard deviations of 200 draws
  }
}

TEST_CASE("cameras of machines see most of their board at every pose") {
  // Proves that sessions are realistic: at least 12 of 35 points in each picture, and most points in most.
  for (const Witness witness : {Witness::wristCamera, Witness::cameraBeside, Witness::footAndHead}) {
    RandomStream chance{5, "sessions of machines"};
    const WorkcellQuestion question = drawWorkcellQuestion({"control", "", 0, witness, 20}, chance);
    for (const WorkcellReading& reading : question.session) {
      CHECK(reading.seen.size() >= 12);
    }
    CHECK(boardShare(question.cell, question.session) > 0.6);
  }
}

TEST_CASE("a machine's ball touches its places up to the contact's noise, with flaws and rounded encoders") {
  // Proves that readings of contacts are those at which the true machine touches.
  RandomStream chance{8, "contacts of machines"};
  WorkcellQuestion question;
  do {
    question = drawWorkcellQuestion({"catalogue", "hysteresis", 80, Witness::touch, 15}, chance);
  } while (question.plan.encoderStep == 0);
  const VectorXd missed = stackMeasurements(question.cell, question.session).head(45);
  CHECK(missed.norm() / std::sqrt(45.0) == Approx(question.plan.sigma).epsilon(0.45));
  for (const WorkcellReading& reading : question.session) {
    CHECK(reading.unread.cwiseAbs().maxCoeff() <= 0.501 * question.plan.encoderStep);
  }
}

TEST_CASE("a design of machines asks for every effect at four sizes and every kind of measurement") {
  // Proves the numbers of sets, and that one group can be drawn alone.
  std::map<std::string, int> groups;
  std::map<double, int> sizes;
  for (const WorkcellItem& item : drawWorkcellDesign(3, 2, "", 1)) {
    ++groups[item.group];
    ++sizes[item.noncentrality];
  }
  const int families = static_cast<int>(machineCatalogue().size());
  CHECK(families >= 10);
  CHECK(groups["control"] == 3 * 6);
  CHECK(groups["catalogue"] == 2 * 4 * families);
  CHECK(sizes[40] == 2 * families);
  CHECK(groups["setup"] > 0);
  CHECK(groups["reading"] > 0);
  CHECK(groups["event"] > 0);
  CHECK(drawWorkcellDesign(3, 2, "event", 1).size() == static_cast<std::size_t>(groups["event"]));
}

} // namespace blind
