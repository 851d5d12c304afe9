// SPDX-License-Identifier: Apache-2.0
#include "tests/support/ViewRays.h"

#include "tests/support/FrameFixture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace test {

PixelRay rayOf(const gpu::VolumeScene& view, const glm::ivec2& frame, double x, double y)
{
    const glm::dvec3 forward = glm::normalize(view.targetLps - view.eyeLps);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, view.up));
    const glm::dvec3 down = glm::cross(forward, right);
    const glm::dvec3 eye = view.eyeLps + right * view.eyeShiftMm;
    const double mm = view.heightMm / frame.y;
    const glm::dvec3 onPlane =
        view.targetLps + right * ((x - frame.x / 2.0) * mm) + down * ((y - frame.y / 2.0) * mm);
    return {onPlane, glm::normalize((view.orthographic ? view.targetLps : onPlane) - eye)};
}

double mmToPlane(const PixelRay& ray, const glm::dvec3& pointLps, const glm::dvec3& normalLps)
{
    return glm::dot(pointLps - ray.origin, normalLps) / glm::dot(ray.direction, normalLps);
}

double gapToSphere(const PixelRay& ray, const glm::dvec3& centreLps, double radiusMm)
{
    const glm::dvec3 offset = centreLps - ray.origin;
    return glm::length(offset - ray.direction * glm::dot(offset, ray.direction)) - radiusMm;
}

double mmToSphere(const PixelRay& ray, const glm::dvec3& centreLps, double radiusMm)
{
    const double middle = glm::dot(centreLps - ray.origin, ray.direction);
    const double aside = glm::length(ray.at(middle) - centreLps);
    return middle - std::sqrt(std::max(radiusMm * radiusMm - aside * aside, 0.0));
}

glm::dvec2 samplingPoint(int picture)
{
    constexpr std::array<std::array<double, 2>, samplingPoints> halton{
        {{0.5, 0.5}, {0.5, 1.0 / 3}, {0.25, 2.0 / 3}, {0.75, 1.0 / 9}, {0.125, 4.0 / 9},
            {0.625, 7.0 / 9}, {0.375, 2.0 / 9}, {0.875, 5.0 / 9}}};
    const auto& at = halton[std::size_t(picture)];
    return {at[0] - 0.5, at[1] - 0.5};
}

int apart(const glm::ivec3& one, const glm::ivec3& other)
{
    const glm::ivec3 by = glm::abs(one - other);
    return std::max({by.r, by.g, by.b});
}

int mostApart(const gpu::Frame& one, const gpu::Frame& other)
{
    int most = 0;
    for (int y = 0; y < one.sizePixels.y; ++y)
        for (int x = 0; x < one.sizePixels.x; ++x)
            most = std::max(most, apart(pixel(one, x, y), pixel(other, x, y)));
    return most;
}

bool isLit(const gpu::Frame& frame, int x, int y)
{
    return pixel(frame, x, y) != glm::ivec3(0);
}

} // namespace test
