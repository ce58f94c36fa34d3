#pragma once

#include "evaluate/ThesisScenery.hpp"

namespace naocal {

/// The poses of a setting: the first of those chosen (thesisPoses), and for both legs their mirror images.
std::vector<ThesisPose> posesOf(const ThesisSetting& setting, const Robot& robot,
                                const std::vector<Eigen::VectorXd>& chosen);

/// As many stable poses as wanted, in each of which all of 40 robots drawn with offsets up to 6.5 degrees see enough
/// (24 corners), chosen one by one: each the one that, on average over such robots, tells most about the offsets beside
/// those before it (largest determinant; corners within 0.3 px, an encoder's noise marginalised). Or the thesis's chain
/// among the same poses: by what looks alike to the cameras of the drawn robot. The first three are the poses for
/// three. Throws InputError when there are not that many.
std::vector<Eigen::VectorXd> thesisPoses(const Robot& robot, ThesisFeature feature, PoseChoice choice,
                                         std::size_t count);

} // namespace naocal
