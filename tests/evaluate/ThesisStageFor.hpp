#pragma once

#include "RobotV6.hpp"
#include "evaluate/ThesisStage.hpp"

#include <map>

namespace naocal {

/// The stage of a setting; its poses are chosen once.
inline ThesisStage thesisStageFor(const ThesisSetting& setting) {
  static std::map<ThesisFeature, std::vector<Eigen::VectorXd>> nested;
  std::vector<Eigen::VectorXd>& all = nested[setting.feature];
  if (all.empty()) {
    all = thesisPoses(v6(), setting.feature, 8);
  }
  return {
      v6(), setting.feature, {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(setting.poses)}, setting.samples};
}

} // namespace naocal
