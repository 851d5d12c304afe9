// SPDX-License-Identifier: Apache-2.0
#include "core/outline/SideCosts.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace core {

namespace {

std::vector<int> brightnessOf(const SlicePixels& picture, int lowCode, int highCode)
{
    const int width = std::max(highCode - lowCode, 1);
    std::vector<int> brightness;
    brightness.reserve(picture.codes.size());
    for (const std::uint16_t code : picture.codes)
        brightness.push_back(std::clamp(int(code) - lowCode, 0, width) * 255 / width);
    return brightness;
}

/// Writes the costs of one row of sides, from the differences across them, which are averaged along
/// the row (rule 2).
/// @param costs where the first is written; the next ones follow at distances of @p step
template <class Difference>
void writeSides(int count, std::size_t step, std::uint8_t* costs,
    const std::array<std::uint8_t, SideCosts::greatestContrast + 1>& costOf,
    const Difference& difference)
{
    int before = difference(0);
    int here = before;
    for (int side = 0; side < count; ++side) {
        const int after = side + 1 < count ? difference(side + 1) : here;
        costs[std::size_t(side) * step] = costOf[std::size_t(std::abs(before + 2 * here + after))];
        before = here;
        here = after;
    }
}

} // namespace

SideCosts sideCosts(const SlicePixels& picture, int lowCode, int highCode)
{
    std::array<std::uint8_t, SideCosts::greatestContrast + 1> costOf{};
    for (int contrast = 0; contrast <= SideCosts::greatestContrast; ++contrast)
        costOf[std::size_t(contrast)] = std::uint8_t(SideCosts::ofContrast(contrast));

    const std::vector<int> brightness = brightnessOf(picture, lowCode, highCode);
    const glm::ivec2 size = picture.size;
    const auto at = [&brightness, &size](int x, int y) {
        return brightness[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
    };
    SideCosts costs{.pixels = size};
    const std::size_t corners = std::size_t(size.x + 1) * std::size_t(size.y + 1);
    costs.along.assign(corners, std::uint8_t(SideCosts::greatest));
    costs.down.assign(corners, std::uint8_t(SideCosts::greatest));
    for (int y = 1; y < size.y; ++y)
        writeSides(size.x, 1, &costs.along[costs.at({0, y})], costOf,
            [&at, y](int x) { return at(x, y) - at(x, y - 1); });
    for (int x = 1; x < size.x; ++x)
        writeSides(size.y, std::size_t(size.x + 1), &costs.down[costs.at({x, 0})], costOf,
            [&at, x](int y) { return at(x, y) - at(x - 1, y); });
    return costs;
}

} // namespace core
