// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/GridGaussian.h"

#include "core/volume/VolumeGeometry.h"

#include <cmath>

namespace core {

namespace {

/// Exponents have 32 binary places, and end where the weights do: 3² / 2.
constexpr int exponentBits = 32;
constexpr std::uint64_t greatestExponent = 9ULL << (exponentBits - 1);
/// Heights have 31, so that the product of two of them fits.
constexpr int heightBits = 31;

/// exp(−exponent): its sixteenth part by the series, which has converged there after eight terms,
/// and then to the power of sixteen by squaring.
std::uint64_t heightAt(std::uint64_t exponent)
{
    constexpr std::uint64_t one = 1ULL << heightBits;
    constexpr int squarings = 4;
    constexpr std::uint64_t terms = 8;
    const std::uint64_t part = exponent >> (exponentBits - heightBits + squarings);
    std::uint64_t height = one;
    for (std::uint64_t term = terms; term > 0; --term)
        height = one - ((part * height) >> heightBits) / term;
    for (int time = 0; time < squarings; ++time)
        height = (height * height) >> heightBits;
    return height;
}

/// Rounded together from the outside inwards: each sum of them is right to half a unit, so that
/// many small ones are not lost.
std::vector<std::uint32_t> weightsFrom(const std::vector<std::uint64_t>& heights)
{
    std::uint64_t total = heights[0];
    for (std::size_t step = 1; step < heights.size(); ++step)
        total += 2 * heights[step];
    std::vector<std::uint32_t> weights(heights.size());
    std::uint64_t beyond = 0; // the heights from a step on
    std::uint64_t rounded = 0;
    for (std::size_t step = heights.size() - 1; step > 0; --step) {
        beyond += heights[step];
        const std::uint64_t now = (beyond * GridGaussian::whole + total / 2) / total;
        weights[step] = std::uint32_t(now - rounded);
        rounded = now;
    }
    weights[0] = GridGaussian::whole - 2 * std::uint32_t(rounded);
    return weights;
}

std::vector<std::uint32_t> weightsAlong(double spacingMm, double sigmaMm)
{
    const double ratio = spacingMm / sigmaMm;
    const double exponent = std::ldexp(ratio * ratio, exponentBits - 1);
    // A step that is longer than three standard deviations has no weight at all.
    const std::uint64_t ofOneStep = exponent < double(greatestExponent)
        ? std::uint64_t(std::floor(exponent + 0.5))
        : greatestExponent + 1;
    std::vector<std::uint64_t> heights;
    for (std::uint64_t step = 0; step * step * ofOneStep <= greatestExponent; ++step)
        heights.push_back(heightAt(step * step * ofOneStep));
    return weightsFrom(heights);
}

} // namespace

GridGaussian gaussianOf(const VolumeGeometry& geometry, double sigmaMm)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    return {{weightsAlong(spacing.x, sigmaMm), weightsAlong(spacing.y, sigmaMm),
        weightsAlong(spacing.z, sigmaMm)}};
}

} // namespace core
