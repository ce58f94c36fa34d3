#pragma once

#include "evaluation/thesis/ThesisExperiment.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// The poses of a setting: the first ones of `chosen` (selectThesisPoses), for both legs also their mirror images.
std::vector<ThesisPose> posesForSetting(const ThesisSetting& setting, const Robot& robot,
                                        const std::vector<Eigen::VectorXd>& chosen);

/// Selects stable poses in which all of 40 robots with random offsets up to 6.5 degrees see at least 24 corners. Greedy
/// D-optimal selection: each pose adds the most information about the offsets, averaged over these robots (0.3 px
/// corner noise, encoder noise marginalised). With PoseChoice::chain: the thesis's chain among the same poses, by
/// similarity of joint rotations to the drawn robot's cameras. Both are nested: the first three are the selection of
/// three. With PoseChoice::program: all poses of the thesis's program (programPoses), whatever the count. Throws
/// InputError if there are fewer than `count` such poses.
std::vector<Eigen::VectorXd> selectThesisPoses(const Robot& robot, ThesisFeature feature, PoseChoice choice,
                                               std::size_t count);

/// Stable poses of the left foot in which the thesis's program would use the picture: angles per name [rad]. They
/// differ from the poses of calibrations. Throws InputError if there are fewer than `count`.
std::vector<Eigen::VectorXd> selectHeldOutPoses(const Robot& robot, const std::vector<std::string>& names,
                                                std::size_t count);

/// Angles of all joints [rad], with these joints at these angles and all others at zero.
Eigen::VectorXd anglesOfAll(const Robot& robot, const std::vector<std::string>& names, const Eigen::VectorXd& angles);

} // namespace naocal
