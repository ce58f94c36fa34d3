#pragma once

#include "RobotV6.hpp"
#include "evaluation/thesis/ThesisExperiment.hpp"
#include "evaluation/thesis/ThesisPoses.hpp"

#include <map>

namespace naocal {

/// Experiment of a setting; its poses are selected once.
inline ThesisExperiment thesisStageFor(const ThesisSetting& setting) {
  static std::map<std::pair<ThesisFeature, PoseChoice>, std::vector<Eigen::VectorXd>> chosen;
  std::vector<Eigen::VectorXd>& all = chosen[{setting.feature, setting.choice}];
  if (all.empty()) {
    all = selectThesisPoses(v6(), setting.feature, setting.choice, 8);
  }
  return {v6(), setting, posesForSetting(setting, v6(), all)};
}

} // namespace naocal
