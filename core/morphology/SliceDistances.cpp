// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/SliceDistances.h"

#include "core/morphology/LowerEnvelope.h"
#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Steps along each row to the nearest pixel with a value; less than 0: the row has none.
std::vector<int> stepsAlongRows(const SliceMask& mask, std::uint8_t value)
{
    std::vector<int> steps(mask.pixels.size());
    const int width = mask.size.x;
    for (int y = 0; y < mask.size.y; ++y) {
        const std::uint8_t* row = &mask.pixels[mask.indexOf({0, y})];
        int* its = &steps[mask.indexOf({0, y})];
        int last = -1;
        for (int x = 0; x < width; ++x) {
            if (row[x] == value)
                last = x;
            its[x] = last < 0 ? -1 : x - last;
        }
        last = -1;
        for (int x = width - 1; x >= 0; --x) {
            if (row[x] == value)
                last = x;
            if (last >= 0 && (its[x] < 0 || last - x < its[x]))
                its[x] = last - x;
        }
    }
    return steps;
}

/// Adds to each pixel without the value its signed squared distance to the nearest pixel with it.
void addSquares(const SliceMask& mask, const SliceSteps& steps, std::uint8_t value,
    std::vector<std::int64_t>& squares)
{
    const std::vector<int> along = stepsAlongRows(mask, value);
    const std::int64_t sign = value == 0 ? 1 : -1;
    LowerEnvelope envelope(steps.yy, std::size_t(mask.size.y));
    for (int x = 0; x < mask.size.x; ++x) {
        envelope.clear(0, mask.size.y);
        for (int y = 0; y < mask.size.y; ++y) {
            if (const std::int64_t step = along[mask.indexOf({x, y})]; step >= 0)
                envelope.add(y, steps.xx * step * step);
        }
        for (int y = 0; y < mask.size.y && !envelope.empty(); ++y)
            squares[mask.indexOf({x, y})] += sign * envelope.at(y);
    }
}

} // namespace

SliceSteps sliceSteps(const VolumeGeometry& geometry, SliceAxis axis)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    const auto squaredOf = [&](int along) { return spacing[along] * spacing[along]; };
    const auto longestOf = [&](int along) {
        const double longest = 3.0 * geometry.size[along] + 2.0;
        return squaredOf(along) * longest * longest;
    };
    const double greatest = std::max(longestOf(acrossOf(axis)), longestOf(downOf(axis)));
    int exponent = 0;
    static_cast<void>(std::frexp(greatest, &exponent)); // greatest < 2^exponent
    constexpr int bits = 58; // of the longest step along one axis
    const auto whole = [&](int along) {
        const double scaled = std::ldexp(squaredOf(along), bits - exponent);
        return std::max<std::int64_t>(1, std::int64_t(std::floor(scaled + 0.5)));
    };
    return {.xx = whole(acrossOf(axis)), .yy = whole(downOf(axis))};
}

std::vector<std::int64_t> signedSquares(const SliceMask& mask, const SliceSteps& steps)
{
    std::vector<std::int64_t> squares(mask.pixels.size(), 0);
    // The distance of a pixel to its own side is 0, so each pixel gets only one of the two.
    addSquares(mask, steps, 0, squares);
    addSquares(mask, steps, 1, squares);
    return squares;
}

} // namespace core
