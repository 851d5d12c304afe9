// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/BlendedSlices.h"

#include "tests/peers/ItkDistances.h"
#include "tests/peers/ItkParts.h"

#include <algorithm>
#include <cmath>

namespace peer {

namespace {

/// A drawn slice with the distance of each pixel to its border, positive inside.
struct DrawnSlice {
    std::vector<std::uint8_t> pixels;
    int parts = 0;
    std::vector<double> depths;
    double milliseconds = 0.0;
};

DrawnSlice drawnSlice(const GridMask& mask, int slice)
{
    const glm::ivec3 size(mask.size.x, mask.size.y, 1);
    const std::size_t pixels = std::size_t(size.x) * std::size_t(size.y);
    const auto own = mask.voxels.subspan(std::size_t(slice) * pixels, pixels);
    DrawnSlice drawn{.pixels = {own.begin(), own.end()}};
    drawn.parts = itkPartCount({.size = size, .spacingMm = mask.spacingMm, .voxels = drawn.pixels});
    if (drawn.parts == 0)
        return drawn;
    // Beyond the image there is nothing: a pixel at its border lies at that of the segment.
    const glm::ivec3 wide = size + glm::ivec3(2, 2, 0);
    std::vector<std::uint8_t> inside(std::size_t(wide.x) * std::size_t(wide.y), 0);
    for (int y = 0; y < size.y; ++y)
        std::copy_n(drawn.pixels.begin() + std::ptrdiff_t(y) * size.x, size.x,
            inside.begin() + std::ptrdiff_t(y + 1) * wide.x + 1);
    std::vector<std::uint8_t> outside(inside.size());
    std::transform(inside.begin(), inside.end(), outside.begin(),
        [](std::uint8_t pixel) { return std::uint8_t(pixel == 0 ? 1 : 0); });
    const ItkDistances toOwn = itkDistances(wide, mask.spacingMm, inside);
    const ItkDistances toRest = itkDistances(wide, mask.spacingMm, outside);
    drawn.milliseconds = toOwn.milliseconds + toRest.milliseconds;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const std::size_t at = std::size_t(y + 1) * std::size_t(wide.x) + std::size_t(x + 1);
            drawn.depths.push_back(inside[at] == 1 ? std::sqrt(double(toRest.squared[at]))
                                                   : -std::sqrt(double(toOwn.squared[at])));
        }
    }
    return drawn;
}

bool isPlain(const DrawnSlice& lower, const DrawnSlice& upper)
{
    if (lower.parts != 1 || upper.parts != 1)
        return false;
    for (std::size_t pixel = 0; pixel < lower.pixels.size(); ++pixel) {
        if (lower.pixels[pixel] == 1 && upper.pixels[pixel] == 1)
            return true;
    }
    return false;
}

} // namespace

PeerMask blendedSlices(const GridMask& mask, int apart)
{
    constexpr double nothingMm = 1e-4;
    PeerMask made{.voxels = {mask.voxels.begin(), mask.voxels.end()},
        .either = std::vector<std::uint8_t>(mask.voxels.size())};
    const std::size_t pixels = std::size_t(mask.size.x) * std::size_t(mask.size.y);
    std::vector<DrawnSlice> drawn; // empty ones are none
    std::vector<int> places;
    for (int slice = 0; slice < mask.size.z; slice += apart) {
        DrawnSlice next = drawnSlice(mask, slice);
        if (next.parts == 0)
            continue;
        made.milliseconds += next.milliseconds;
        drawn.push_back(std::move(next));
        places.push_back(slice);
    }
    for (std::size_t gap = 1; gap < drawn.size(); ++gap) {
        const DrawnSlice& lower = drawn[gap - 1];
        const DrawnSlice& upper = drawn[gap];
        const bool plain = isPlain(lower, upper);
        const double of = places[gap] - places[gap - 1];
        for (int slice = places[gap - 1] + 1; slice < places[gap]; ++slice) {
            const double done = (slice - places[gap - 1]) / of;
            for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
                const double depth =
                    (1.0 - done) * lower.depths[pixel] + done * upper.depths[pixel];
                const std::size_t voxel = std::size_t(slice) * pixels + pixel;
                made.voxels[voxel] = depth >= 0.0 ? 1 : 0;
                made.either[voxel] = !plain || std::abs(depth) <= nothingMm ? 1 : 0;
            }
        }
    }
    return made;
}

} // namespace peer
