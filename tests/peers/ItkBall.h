// SPDX-License-Identifier: Apache-2.0
#pragma once

// For the sources of peers alone, which see ITK.

#include <glm/glm.hpp>

#include <itkOffset.h>
#include <itkSize.h>

#include <cmath>

namespace peer {

/// By how much the square of a radius is enlarged, as in Burin, so that a ball of three voxels
/// reaches the third one.
constexpr double ballSlack = 1e-6;

/// Voxels on either side of the middle that a ball of millimetres may reach.
inline itk::Size<3> ballRadius(const glm::dvec3& spacingMm, double radiusMm)
{
    itk::Size<3> radius;
    for (unsigned axis = 0; axis < 3; ++axis)
        radius[axis] = static_cast<itk::SizeValueType>(
            std::floor(radiusMm * (1.0 + ballSlack) / spacingMm[static_cast<int>(axis)]));
    return radius;
}

inline bool isInBall(const itk::Offset<3>& step, const glm::dvec3& spacingMm, double radiusMm)
{
    double squared = 0.0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const double mm = double(step[axis]) * spacingMm[static_cast<int>(axis)];
        squared += mm * mm;
    }
    return squared <= radiusMm * radiusMm * (1.0 + ballSlack);
}

} // namespace peer
