#pragma once

#include "synthetic/Rendering.hpp"

#include <random>
#include <vector>

namespace naocal {

/// A value per pixel, row after row: blotches of several sizes with mean 0 and standard deviation about 1, fixed to the
/// picture.
std::vector<float> blotches(int width, int height, std::mt19937_64& random);

/// What the lens and the sensor make of the light (0 ink, 1 paper) that falls on the pixels.
GreyPicture developed(std::vector<float> light, int width, int height, const Appearance& appearance,
                      std::mt19937_64& random);

} // namespace naocal
