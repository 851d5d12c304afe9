// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourRule.h"

#include "core/morphology/MillimetreBall.h"
#include "core/volume/VolumeGeometry.h"

#include <algorithm>

namespace core {

ContourKernel contourKernel(const VolumeGeometry& geometry)
{
    constexpr double usual = 2.5; // finest spacings
    constexpr double most = 4.0;
    constexpr double ofCoarsest = 1.25;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double finest = std::min({spacing.x, spacing.y, spacing.z});
    const double coarsest = std::max({spacing.x, spacing.y, spacing.z});
    const double radius = std::max(usual * finest, std::min(ofCoarsest * coarsest, most * finest));
    return contourKernel(ballOf(geometry, radius));
}

ContourKernel contourKernel(const MillimetreBall& ball)
{
    constexpr std::int64_t heaviest = 256;
    const std::int64_t unit = std::max<std::int64_t>(ball.squaredRadius / heaviest, 1);
    ContourKernel kernel;
    for (int z = -ball.extent.z; z <= ball.extent.z; ++z) {
        for (int y = -ball.extent.y; y <= ball.extent.y; ++y) {
            for (int x = -ball.extent.x; x <= ball.extent.x; ++x) {
                const std::int64_t left = ball.squaredRadius - ball.squared(x, y, z);
                const glm::ivec3 to(x, y, z);
                if (to == glm::ivec3(0) || left < unit)
                    continue;
                const int weight = int(std::min(left / unit, heaviest));
                kernel.steps.push_back({.to = to, .weight = weight});
                kernel.extent = glm::max(kernel.extent, glm::abs(to));
                kernel.total += weight;
            }
        }
    }
    return kernel;
}

int regionSpeed(const ContourRule& rule, int code)
{
    constexpr std::int64_t full = 256;
    const std::int64_t inside = std::min(code - rule.lowCode, rule.highCode - code);
    const auto speed =
        int(std::clamp(full * (2 * inside + 1) / (2 * rule.softness + 1), -full, full));
    return rule.erase ? -speed : speed;
}

int edgeWeight(const ContourRule& rule, std::uint64_t squaredMagnitude)
{
    constexpr int even = 255;
    constexpr int whole = 100; // rule.edge
    const std::uint64_t half = std::uint64_t(rule.halfGradient) * std::uint64_t(rule.halfGradient);
    const int steep = 1 + int((even - 1) * half / (half + squaredMagnitude));
    return even - rule.edge * (even - steep) / whole;
}

} // namespace core
