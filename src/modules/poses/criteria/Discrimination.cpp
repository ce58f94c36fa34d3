#include "poses/criteria/Discrimination.hpp"

#include "calibration/result/Wording.hpp"
#include "effects/UserEffect.hpp"
#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

Discrimination::Discrimination(const ModelAmbiguity& question, Eigen::Index own) : question_{question}, own_{own} {
  Eigen::Index column = 0;
  for (const Hypothesis& suspect : question.suspects) {
    first_.push_back(column);
    column += suspect.size.size();
  }
  double sum = 0;
  for (std::size_t one = 0; one < question.suspects.size(); ++one) {
    const double odds = question.suspects[one].odds;
    if (!question.rivals) {
      pairs_.push_back({one, std::nullopt, odds});
    }
    for (std::size_t other = 0; question.rivals && other < question.suspects.size(); ++other) {
      if (other != one) {
        pairs_.push_back({one, other, odds * question.suspects[other].odds});
      }
    }
  }
  for (const Pair& pair : pairs_) {
    sum += pair.weight;
  }
  for (Pair& pair : pairs_) { // odds below all numbers: alike
    pair.weight = sum > 0 ? pair.weight / sum : 1 / static_cast<double>(pairs_.size());
  }
}

Eigen::VectorXd Discrimination::misfits(const Eigen::MatrixXd& hessian) const {
  const Eigen::Index suspects = hessian.rows() - own_;
  const Eigen::LLT<Eigen::MatrixXd> own{hessian.topLeftCorner(own_, own_)};
  const Eigen::MatrixXd half = own.matrixL().solve(hessian.topRightCorner(own_, suspects));
  const Eigen::MatrixXd kept = hessian.bottomRightCorner(suspects, suspects) - half.transpose() * half;
  const auto block = [&](std::size_t one, std::size_t other) {
    return kept.block(first_[one], first_[other], question_.suspects[one].size.size(),
                      question_.suspects[other].size.size());
  };
  Eigen::VectorXd result(eigenIndex(pairs_.size()));
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const Eigen::VectorXd& size = question_.suspects[pair.one].size;
    result[eigenIndex(i)] = size.dot(block(pair.one, pair.one) * size);
    if (pair.other) {
      Eigen::MatrixXd rival = block(*pair.other, *pair.other);
      rival.diagonal() += question_.suspects[*pair.other].plausible.cwiseAbs2().cwiseInverse();
      const Eigen::VectorXd imitated = block(*pair.other, pair.one) * size;
      result[eigenIndex(i)] -= imitated.dot(rival.llt().solve(imitated));
    }
  }
  return result.cwiseMax(0);
}

double Discrimination::expectedGain(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const {
  double sum = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    sum += pairs_[i].weight * (1 - std::exp((before[eigenIndex(i)] - after[eigenIndex(i)]) / 8));
  }
  return sum;
}

double Discrimination::growthFactor(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const {
  constexpr double nothing = 1e-3; // undetectable misfit; avoids log(0)
  double sum = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    sum += pairs_[i].weight * std::log((after[eigenIndex(i)] + nothing) / (before[eigenIndex(i)] + nothing));
  }
  return std::exp(sum);
}

namespace {

/// limits the computing time
constexpr std::size_t mostSuspects = 8;

/// Adds the most likely suspects and converts their evidence to odds.
void suspect(std::vector<Hypothesis> suspects, std::vector<double> evidence, ModelAmbiguity& question) {
  std::vector<std::size_t> order(suspects.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return evidence[a] > evidence[b]; });
  order.resize(std::min(order.size(), mostSuspects));
  std::vector<double> kept;
  for (const std::size_t i : order) {
    question.suspects.push_back(std::move(suspects[i]));
    kept.push_back(evidence[i]);
  }
  const std::vector<double> odds = posteriorProbabilities(kept);
  for (std::size_t i = 0; i < odds.size(); ++i) {
    question.suspects[i].odds = odds[i];
  }
}

/// "a, b and c", from the suspect `first` on; names at most three.
std::string nameHypotheses(const std::vector<Hypothesis>& suspects, std::size_t first) {
  constexpr std::size_t most = 3;
  std::vector<std::string> words;
  for (std::size_t i = first; i < std::min(suspects.size(), first + most); ++i) {
    words.push_back(suspects[i].label);
  }
  if (suspects.size() > first + most) {
    words.push_back(fmt::format("{} more", suspects.size() - first - most));
  }
  return joinWords(words);
}

/// Fills `question`: which member of the head's equivalence class is present. False if all its alternatives are
/// already in the model. As the captures cannot tell the members apart, none is much less likely than the head: the
/// evidence of an effect with a kink, such as a gear's play, is linearised where it is weakest.
bool askWhichOne(const Diagnosis& diagnosis, const CandidateFinding& head, ModelAmbiguity& question) {
  std::vector<Hypothesis> suspects;
  std::vector<double> evidence;
  for (const CandidateFinding& finding : diagnosis.ranking) {
    const std::string label = finding.term.label();
    const bool twin = std::find(head.equivalent.begin(), head.equivalent.end(), label) != head.equivalent.end();
    const bool taken = std::find(question.with.begin(), question.with.end(), label) != question.with.end();
    if (label == head.term.label() || (twin && !taken)) {
      suspects.push_back({label, finding.evidence.estimate, finding.term.sigmas()});
      evidence.push_back(std::max(finding.evidence.bayes, head.evidence.bayes - threshold::equallyLikely));
    }
  }
  if (suspects.size() < 2) {
    return false;
  }
  std::erase(question.with, head.term.label());
  suspect(std::move(suspects), std::move(evidence), question);
  question.rivals = true;
  question.why = fmt::format("tells {} from {}", question.suspects.front().label, nameHypotheses(question.suspects, 1));
  return true;
}

/// Fills `question`: whether the unexplained curve, as a custom effect, or its best rival in the catalogue is present.
void askAboutCurve(const Diagnosis& diagnosis, const Robot& robot, ModelAmbiguity& question) {
  const DriverCurve& curve = diagnosis.driverCurves.front();
  const auto rival = std::find_if(diagnosis.ranking.begin(), diagnosis.ranking.end(), [&](const auto& finding) {
    return finding.state != CandidateState::noData && finding.state != CandidateState::present &&
           finding.evidence.freedom > 0;
  });
  if (rival == diagnosis.ranking.end() || curve.expression.empty()) {
    return;
  }
  nlohmann::json definition{{"name", "curve"}, {"at", curve.place}, {"correction", curve.expression}};
  Eigen::VectorXd size(static_cast<Eigen::Index>(curve.coefficients.size()));
  for (Eigen::Index i = 0; i < size.size(); ++i) {
    const auto& [name, value, unit] = curve.coefficients[static_cast<std::size_t>(i)];
    size[i] = value;
    definition["unknowns"][name] = {{"unit", unit}, {"sigma", std::max(std::abs(value), 1e-6)}};
  }
  question.effects.push_back(parseUserEffect(JsonCursor{definition, "the curve"}, robot));
  const Eigen::VectorXd plausible = Term{question.effects.back()}.sigmas();
  suspect({{"curve@" + curve.place, size, plausible},
           {rival->term.label(), rival->evidence.estimate, rival->term.sigmas()}},
          {curve.bayes, rival->evidence.bayes}, question);
  question.rivals = true;
  question.why = fmt::format("tells a curve of {} over {} from {}", curve.place, curve.driver, rival->term.label());
}

void askWhether(const Diagnosis& diagnosis, CandidateState state, ModelAmbiguity& question) {
  constexpr std::size_t few = 3;
  std::vector<Hypothesis> suspects;
  std::vector<double> evidence;
  for (const CandidateFinding& finding : diagnosis.ranking) { // strongest first
    if (finding.state == state && suspects.size() < few) {
      const Eigen::VectorXd plausible = finding.term.sigmas();
      suspects.push_back({finding.term.label(), plausible, plausible});
      evidence.push_back(finding.evidence.bayes);
    }
  }
  if (!suspects.empty()) {
    suspect(std::move(suspects), std::move(evidence), question);
    question.why = fmt::format("shows whether {} {} there", nameHypotheses(question.suspects, 0),
                               question.suspects.size() == 1 ? "is" : "are");
  }
}

} // namespace

std::vector<double> posteriorProbabilities(const std::vector<double>& evidence) {
  const double most = evidence.empty() ? 0 : *std::max_element(evidence.begin(), evidence.end());
  std::vector<double> result;
  double sum = 0;
  for (const double each : evidence) {
    result.push_back(std::exp((each - most) / 2));
    sum += result.back();
  }
  for (double& each : result) {
    each /= sum;
  }
  return result;
}

ModelAmbiguity findAmbiguity(const Diagnosis& diagnosis, const Robot& robot, const DiagnosisOptions& asked) {
  ModelAmbiguity question{.suspects = {},
                          .with = diagnosis.with,
                          .without = asked.without,
                          .effects = asked.calibration.effects,
                          .why = {}};
  if (diagnosis.verdict == Verdict::badCaptures && !diagnosis.hasStillJoints) {
    question.whyNone = "put the captures right first, further ones would suffer from the same";
    return question;
  }
  if (diagnosis.verdict == Verdict::unknownEffect) {
    askAboutCurve(diagnosis, robot, question);
    if (question.suspects.empty()) {
      const DriverCurve& curve = diagnosis.driverCurves.front();
      question.whyNone =
          fmt::format("poses are proposed to tell a joint's curve from effects, and what is missing sits at {} over {}",
                      curve.place, curve.driver);
    }
    return question;
  }
  for (const std::string& label : diagnosis.suggested) {
    const auto head = std::find_if(diagnosis.ranking.begin(), diagnosis.ranking.end(),
                                   [&](const CandidateFinding& finding) { return finding.term.label() == label; });
    if (head != diagnosis.ranking.end() && askWhichOne(diagnosis, *head, question)) {
      return question;
    }
  }
  askWhether(diagnosis, CandidateState::inconclusive, question);
  if (question.suspects.empty()) {
    askWhether(diagnosis, CandidateState::absorbed, question);
  }
  if (question.suspects.empty()) {
    question.whyNone = "the captures leave nothing open";
  }
  return question;
}

} // namespace naocal
