// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/filling/Contour.h"

#include "core/morphology/MillimetreBall.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace reference {

namespace {

struct ContourGrid {
    glm::ivec3 size;

    [[nodiscard]] std::size_t at(const glm::ivec3& voxel) const
    {
        return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
            * std::size_t(size.x)
            + std::size_t(voxel.x);
    }
    [[nodiscard]] bool holds(const glm::ivec3& voxel) const
    {
        return voxel == glm::clamp(voxel, glm::ivec3(0), size - 1);
    }
    template <class Visit> void visitAll(Visit&& visit) const
    {
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x)
                    visit(glm::ivec3(x, y, z));
            }
        }
    }
};

/// w(d) from the words of contourKernel().
struct Weights {
    explicit Weights(const core::VolumeGeometry& geometry)
    {
        const glm::dvec3 spacing = geometry.spacingMm();
        const double finest = std::min({spacing.x, spacing.y, spacing.z});
        const double coarsest = std::max({spacing.x, spacing.y, spacing.z});
        double radius = 2.5 * finest;
        if (1.25 * coarsest > radius)
            radius = std::min(1.25 * coarsest, 4.0 * finest);
        ball = core::ballOf(geometry, radius);
    }
    [[nodiscard]] int of(const glm::ivec3& step) const
    {
        if (step == glm::ivec3(0))
            return 0;
        const std::int64_t unit = std::max<std::int64_t>(ball.squaredRadius / 256, 1);
        const std::int64_t left = ball.squaredRadius - ball.squared(step.x, step.y, step.z);
        return left < unit ? 0 : int(std::min<std::int64_t>(left / unit, 256));
    }
    template <class Visit> void visitSteps(Visit&& visit) const
    {
        const glm::ivec3 far = ball.extent + 1;
        for (int z = -far.z; z <= far.z; ++z) {
            for (int y = -far.y; y <= far.y; ++y) {
                for (int x = -far.x; x <= far.x; ++x) {
                    if (of({x, y, z}) > 0)
                        visit(glm::ivec3(x, y, z), std::int64_t(of({x, y, z})));
                }
            }
        }
    }
    core::MillimetreBall ball;
};

std::int64_t regionAt(const Contour& contour, const ContourGrid& grid, const glm::ivec3& voxel)
{
    const int code = contour.study->codes[grid.at(voxel)];
    const std::int64_t within = std::min(code - contour.rule.lowCode, contour.rule.highCode - code);
    const std::int64_t speed = 256 * (2 * within + 1) / (2 * contour.rule.softness + 1);
    const std::int64_t full = speed > 256 ? 256 : speed < -256 ? -256 : speed;
    return contour.rule.erase ? -full : full;
}

std::int64_t evennessAt(const Contour& contour, const ContourGrid& grid, const glm::ivec3& voxel)
{
    std::uint64_t m = 0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 ahead = voxel;
        glm::ivec3 behind = voxel;
        ahead[axis] = std::min(ahead[axis] + 1, grid.size[axis] - 1);
        behind[axis] = std::max(behind[axis] - 1, 0);
        const int difference = std::abs(
            int(contour.study->codes[grid.at(ahead)]) - int(contour.study->codes[grid.at(behind)]));
        const std::int64_t t = std::min<std::int64_t>(
            std::int64_t(contour.rule.gradientWeights[axis]) * difference / 1024, 32767);
        m += std::uint64_t(t * t);
    }
    const auto k =
        std::uint64_t(contour.rule.halfGradient) * std::uint64_t(contour.rule.halfGradient);
    const auto h = std::int64_t(1 + 254 * k / (k + m));
    return 255 - contour.rule.edge * (255 - h) / 100;
}

bool isAtFront(
    const Contour& contour, const ContourGrid& grid, const glm::ivec3& voxel, bool isWide)
{
    const std::size_t own = grid.at(voxel);
    if (!contour.open[own])
        return false;
    for (int step = 0; step < 27; ++step) {
        const glm::ivec3 to(step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
        const int axes = std::abs(to.x) + std::abs(to.y) + std::abs(to.z);
        if (axes == 0 || axes > (isWide ? 2 : 1) || !grid.holds(voxel + to)
            || contour.isAbsent(grid.at(voxel + to)))
            continue;
        if (contour.inside[grid.at(voxel + to)] != contour.inside[own])
            return true;
    }
    return false;
}

/// Asks the front once. @return how many voxels changed
std::size_t askFront(Contour& contour, bool isWide)
{
    const core::LoadedVolume* study = contour.study;
    const core::ContourRule& rule = contour.rule;
    std::vector<bool>& inside = contour.inside;
    const ContourGrid grid{study->volume.geometry.size};
    const Weights weights(study->volume.geometry);
    glm::ivec3 period(2);
    std::int64_t total = 0;
    weights.visitSteps([&](const glm::ivec3& to, std::int64_t weight) {
        period = glm::max(period, glm::abs(to) + 1);
        total += weight;
    });
    std::map<int, std::vector<glm::ivec3>> classes;
    grid.visitAll([&](const glm::ivec3& voxel) {
        const glm::ivec3 in = voxel % period;
        if (isAtFront(contour, grid, voxel, isWide))
            classes[in.x + period.x * (in.y + period.y * in.z)].push_back(voxel);
    });
    std::size_t changed = 0;
    for (const auto& [number, voxels] : classes) {
        // One after the other, backwards: within a class that must not matter.
        for (auto each = voxels.rbegin(); each != voxels.rend(); ++each) {
            const glm::ivec3 voxel = *each;
            if (!isAtFront(contour, grid, voxel, isWide))
                continue;
            const std::int64_t g = evennessAt(contour, grid, voxel);
            std::int64_t around = 0;
            weights.visitSteps([&](const glm::ivec3& to, std::int64_t weight) {
                if (grid.holds(voxel + to) && !contour.isAbsent(grid.at(voxel + to)))
                    around += weight * (g + evennessAt(contour, grid, voxel + to))
                        * (inside[grid.at(voxel + to)] ? 1 : -1);
            });
            const std::int64_t speed =
                rule.region * total * regionAt(contour, grid, voxel) + rule.smoothness * around;
            const std::size_t own = grid.at(voxel);
            if (inside[own] ? speed < 0 : speed > 0) {
                inside[own] = !inside[own];
                ++changed;
            }
        }
    }
    return changed;
}

} // namespace

std::size_t Contour::step()
{
    const bool isWide = rule.round && generation % 2 == 1;
    std::size_t changed = askFront(*this, isWide);
    if (changed == 0 && rule.round && !isWide)
        changed = askFront(*this, true);
    if (changed > 0)
        ++generation;
    return changed;
}

double Contour::energy() const
{
    const ContourGrid grid{study->volume.geometry.size};
    const Weights weights(study->volume.geometry);
    std::int64_t total = 0;
    weights.visitSteps([&](const glm::ivec3&, std::int64_t weight) { total += weight; });
    double values = 0.0;
    double pairs = 0.0; // each twice
    grid.visitAll([&](const glm::ivec3& voxel) {
        if (isAbsent(grid.at(voxel)))
            return;
        const double x = inside[grid.at(voxel)] ? 1.0 : -1.0;
        values += double(regionAt(*this, grid, voxel)) * x;
        const std::int64_t g = evennessAt(*this, grid, voxel);
        weights.visitSteps([&](const glm::ivec3& to, std::int64_t weight) {
            if (grid.holds(voxel + to) && !isAbsent(grid.at(voxel + to)))
                pairs += double(weight * (g + evennessAt(*this, grid, voxel + to))) * x
                    * (inside[grid.at(voxel + to)] ? 1.0 : -1.0);
        });
    });
    return -rule.region * double(total) * values - rule.smoothness * 0.5 * pairs;
}

Contour contourOf(const core::EvolveContour& edit, const core::ContourRule& rule,
    const core::LoadedVolume& study, std::span<const std::uint8_t> labels,
    const std::function<bool(int label)>& mayTake)
{
    const core::VolumeGeometry& geometry = study.volume.geometry;
    const ContourGrid grid{geometry.size};
    Contour contour{.study = &study, .rule = rule};
    std::vector<glm::dvec3> bubbles;
    if (edit.bubbleLps)
        bubbles.push_back(*edit.bubbleLps);
    if (edit.bubbleLps && edit.furtherBubblesLps)
        bubbles.insert(
            bubbles.end(), edit.furtherBubblesLps->begin(), edit.furtherBubblesLps->end());
    grid.visitAll([&](const glm::ivec3& voxel) {
        const int label = labels[grid.at(voxel)];
        const bool isOwn = label == edit.segment;
        const bool erases = edit.erase == true;
        const bool mayChange = isOwn || (!erases && (label == 0 || mayTake(label)));
        bool isInside = isOwn;
        for (const glm::dvec3& bubble : bubbles) {
            const glm::dvec3 middle = glm::floor(geometry.toIndex(bubble) + 0.5);
            const glm::dvec3 to = geometry.toWorld(glm::dvec3(voxel)) - geometry.toWorld(middle);
            if (mayChange && glm::length(to) <= edit.bubbleMm)
                isInside = !erases;
        }
        contour.absent.push_back(erases && edit.bubbleLps && !isOwn);
        contour.open.push_back(mayChange);
        contour.inside.push_back(isInside);
    });
    return contour;
}

std::vector<bool> evolvedContour(const core::EvolveContour& edit, const core::ContourRule& rule,
    const core::LoadedVolume& study, std::span<const std::uint8_t> labels,
    const std::function<bool(int label)>& mayTake)
{
    Contour contour = contourOf(edit, rule, study, labels, mayTake);
    for (int generation = 0; generation < edit.generations; ++generation) {
        if (contour.step() == 0)
            break;
    }
    return contour.inside;
}

} // namespace reference
