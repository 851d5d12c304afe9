// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/TileCosts.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace gpu {

namespace {

/// Two tiles are under way at a time, one drawn and one queued, so that no processor waits for this
/// thread to wake up; together they are what an edit may have to wait for.
constexpr double sliceMilliseconds = 5.0;
constexpr double coarseMilliseconds = 40.0;
/// Of a coarse picture while edits run: they take about as long again. Under the pen it is drawn in
/// one slice, since an edit between its tiles would only show it later.
constexpr double editingMilliseconds = 20.0;
/// A full picture expected to be faster than this comes at once, without a coarse one before it.
constexpr double directMilliseconds = 90.0;
constexpr int coarsest = 6;

} // namespace

TileCosts::TileCosts()
{
    // Guesses of a software renderer; the first tiles correct them.
    m_costs[0] = {60.0, 500.0, 800.0, 800.0, 1500.0};
    m_costs[1] = {300.0, 800.0, 1100.0, 1100.0, 1800.0};
}

double& TileCosts::of(const Scene& scene, bool cubics)
{
    auto& costs = m_costs[cubics ? 1 : 0];
    if (const auto* volume = std::get_if<VolumeScene>(&scene))
        return costs[1 + std::size_t(volume->mode)];
    return costs[0];
}

void TileCosts::learn(double& cost, double milliseconds, double pixels)
{
    // Follows slowly and by bounded steps: a first use compiles, a corner may be empty.
    const double measured = milliseconds / pixels * 1e6;
    cost = std::clamp(0.7 * cost + 0.3 * measured, 0.5 * cost, 2.0 * cost);
}

double TileCosts::pixelsAtOnce(double cost, bool editing, bool interacting)
{
    // While edits run one tile is under way, not two.
    const double budget = !editing ? sliceMilliseconds
        : interacting              ? editingMilliseconds
                                   : 2.0 * sliceMilliseconds;
    return budget / cost * 1e6;
}

int TileCosts::coarseFactor(
    double cost, const glm::ivec2& sizePixels, bool editing, bool interacting)
{
    const glm::dvec2 size(sizePixels);
    const double expected = cost * size.x * size.y * 1e-6;
    const double wanted = editing ? editingMilliseconds : coarseMilliseconds;
    const bool patient = !interacting && !editing;
    if (expected <= (patient ? directMilliseconds : wanted))
        return 1;
    return std::clamp(int(std::ceil(std::sqrt(expected / wanted))), 1, coarsest);
}

} // namespace gpu
