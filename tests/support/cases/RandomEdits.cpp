// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/RandomEdits.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/sculpt/ToolMask.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace test {

namespace {

/// Where a random one covers next to nothing.
const std::vector<glm::dvec2> largeOutline{{-6.0, -5.0}, {7.0, -4.0}, {0.0, 8.0}};

glm::dvec3 randomDirection(Random& random)
{
    glm::dvec3 v;
    do {
        v = {2.0 * randomUnit(random) - 1.0, 2.0 * randomUnit(random) - 1.0,
            2.0 * randomUnit(random) - 1.0};
    } while (glm::length(v) < 0.1 || glm::length(v) > 1.0);
    return glm::normalize(v);
}

core::ToolMask randomMask(double radiusMm, Random& random)
{
    core::ToolMask mask;
    mask.radiusMm = radiusMm;
    mask.kind = core::ToolMask::Kind(randomInt(random, 0, 4));
    mask.widthMm = 0.5 + 2.0 * radiusMm * randomUnit(random);
    mask.heightMm = 0.5 + 2.0 * radiusMm * randomUnit(random);
    mask.cornerMm = std::max(radiusMm * randomUnit(random), 0.02);
    mask.rotationDegrees = randomInt(random, -360, 360);
    if (random() % 3 == 0)
        mask.polygonMm = randomOutline(radiusMm, random);
    if (random() % 3 == 0)
        mask.softnessMm = 1.5 * radiusMm * randomUnit(random);
    return mask;
}

/// Masks, modes and pen times, often.
void randomise(core::DrillStroke& stroke, double reach, Random& random)
{
    if (random() % 2)
        stroke.mask = randomMask(stroke.mask.radiusMm, random);
    stroke.restore = random() % 4 == 0;
    stroke.byTime = random() % 2;
    if (random() % 3 == 0)
        stroke.guardMm = 0.1 + 0.3 * reach * randomUnit(random);
    if (random() % 4 == 0) {
        stroke.mode = core::DrillMode::Rate;
        stroke.floorMm = reach * randomUnit(random);
        stroke.depthMm = std::min(4.0 * stroke.depthMm, 500.0); // the most that an edit may say
    }
    double seconds = 0.0;
    for (core::PenSample& sample : stroke.samples) {
        sample.tSeconds = seconds;
        seconds += random() % 4 ? randomInt(random, 1, 3000) / 10000.0 : 0.0;
    }
}

} // namespace

core::Document randomDocument(const glm::ivec3& size, Random& random, bool sheared)
{
    const glm::dvec3 x = randomDirection(random);
    const glm::dvec3 y = glm::normalize(glm::cross(x, randomDirection(random)));
    glm::dvec3 z = glm::cross(x, y);
    if (sheared)
        z = glm::normalize(z + 0.3 * y);
    // One after the other: compilers differ in the order of a call's arguments.
    const glm::dvec3 originLps = 100.0 * randomDirection(random);
    const auto spacing = [&] { return 0.4 + 1.8 * randomUnit(random); };
    const double ofSlices = spacing();
    const double ofRows = spacing();
    const double ofColumns = spacing();
    core::Volume volume;
    volume.geometry.size = size;
    volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(x * ofColumns, 0.0),
        glm::dvec4(y * ofRows, 0.0), glm::dvec4(z * ofSlices, 0.0), glm::dvec4(originLps, 1.0));
    core::Document document;
    document.volumes.push_back(volume);
    document.layers.push_back({.id = 1, .name = QStringLiteral("Sculpt 1")});
    document.layers.push_back({.id = 2, .name = QStringLiteral("Sculpt 2")});
    return document;
}

std::vector<glm::dvec2> randomOutline(double reachMm, Random& random)
{
    std::vector<glm::dvec2> outline;
    for (int i = randomInt(random, 2, 9); i > 0; --i)
        outline.push_back(
            2.0 * reachMm * glm::dvec2{randomUnit(random) - 0.5, randomUnit(random) - 0.5});
    // Whatever those are, the corner at the end keeps it from being too small.
    const glm::dvec2 last = outline.back();
    outline.push_back(last + glm::dvec2(reachMm + 1.5, 0.0));
    outline.push_back(last + glm::dvec2(0.0, reachMm + 1.5));
    return outline;
}

core::PeelCut randomPeel(const core::Document& document, Random& random)
{
    const auto from = randomDrill(document, random).get<core::DrillStroke>();
    const double reachMm = from.mask.radiusMm;
    core::PeelCut peel;
    peel.layer = from.layer;
    peel.view = from.view;
    peel.polygonMm = randomOutline(reachMm, random);
    peel.depthMm = std::min(random() % 8 ? reachMm * randomUnit(random) : 0.0, 20.0);
    peel.surfaceThreshold = from.surfaceThreshold;
    peel.throughGaps = from.throughGaps;
    peel.jumpMm = random() % 3 ? 0.5 + 4.0 * randomUnit(random) : 0.0;
    peel.restore = random() % 3 == 0;
    peel.hidden = from.hidden;
    if (!core::shellPeel(peel, document))
        peel.polygonMm = largeOutline;
    return peel;
}

core::ScissorsCut randomScissors(const core::Document& document, Random& random)
{
    const auto from = randomDrill(document, random).get<core::DrillStroke>();
    core::ScissorsCut cut;
    cut.layer = from.layer;
    cut.view = from.view;
    cut.polygonMm = randomOutline(from.mask.radiusMm, random);
    cut.surfaceThreshold = from.surfaceThreshold;
    if (random() % 2)
        cut.depthMm = 1.0 + from.mask.radiusMm * randomUnit(random);
    cut.restore = random() % 3 == 0;
    cut.firstLayerOnly = !cut.restore && random() % 2;
    cut.hidden = from.hidden;
    if (!core::outlineCut(cut, document))
        cut.polygonMm = largeOutline;
    return cut;
}

core::SegmentScissors randomSegmentScissors(const core::Document& document, Random& random)
{
    const core::ScissorsCut from = randomScissors(document, random);
    const core::Segment& segment =
        document.segments[std::size_t(randomInt(random, 0, int(document.segments.size()) - 1))];
    core::SegmentScissors scissors{
        .segment = segment.label, .view = from.view, .polygonMm = from.polygonMm};
    scissors.hidden = from.hidden;
    scissors.erase = random() % 2 == 0;
    scissors.outside = random() % 4 == 0;
    if (!scissors.outside && random() % 2)
        scissors.depthMm = 12.0 * randomUnit(random);
    scissors.overwriteUnlocked = !scissors.erase && random() % 2 == 0;
    if (scissors.erase && random() % 2) {
        std::vector<int> others;
        for (const core::Segment& other : document.segments) {
            if (&other != &segment && other.plane == segment.plane && random() % 2)
                others.push_back(other.label);
        }
        std::sort(others.begin(), others.end());
        if (!others.empty())
            scissors.others = others;
    }
    if (random() % 3 == 0)
        scissors.lower = randomInt(random, 0, tissueCode);
    if (random() % 4 == 0)
        scissors.upper = scissors.lower.value_or(0.0) + randomInt(random, 0, tissueCode);
    return scissors;
}

core::ClipHalfSpace beyond(const glm::dvec3& placeLps, const glm::dvec3& normalLps)
{
    const glm::dvec3 normal = glm::normalize(normalLps);
    return {normal, glm::dot(normal, placeLps)};
}

core::ClipHalfSpaces randomHidden(const core::Document& document, Random& random)
{
    if (random() % 4 != 0)
        return std::nullopt;
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    std::vector<core::ClipHalfSpace> sides;
    for (int i = randomInt(random, 1, 3); i > 0; --i) {
        const glm::dvec3 normal =
            random() % 2 ? randomDirection(random) : geometry.direction()[randomInt(random, 0, 2)];
        const glm::dvec3 place = geometry.toWorld(glm::dvec3(randomVoxel(random, geometry.size)));
        sides.push_back(beyond(place, normal));
    }
    return sides;
}

core::LaserStroke randomLaser(const core::Document& document, Random& random)
{
    const auto from = randomDrill(document, random).get<core::DrillStroke>();
    core::LaserStroke laser;
    laser.layer = from.layer;
    laser.view = from.view;
    laser.mask = from.mask;
    laser.mode = from.mode;
    laser.depthMm = from.depthMm;
    laser.floorMm = from.floorMm;
    laser.pressureExponent = from.pressureExponent;
    laser.surfaceThreshold = from.surfaceThreshold;
    laser.throughGaps = from.throughGaps;
    laser.restore = from.restore;
    laser.byTime = from.byTime;
    laser.samples = from.samples;
    laser.hidden = from.hidden;
    if (!core::laserCut(laser, document)) // too small a mask for these voxels
        laser.mask = {.radiusMm = 3.0};
    return laser;
}

core::Edit randomDrill(const core::Document& document, Random& random)
{
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    const glm::dvec3 extent = glm::dvec3(geometry.size) * geometry.spacingMm();
    const double reach = glm::length(extent) / 2.0;
    core::DrillStroke stroke;
    stroke.layer = randomInt(random, 1, 2);
    stroke.view.targetLps = geometry.toWorld(glm::dvec3(randomVoxel(random, geometry.size)));
    const glm::dvec3 towards = randomInt(random, 0, 3) > 0
        ? randomDirection(random)
        : geometry.direction()[randomInt(random, 0, 2)] * (random() % 2 ? 1.0 : -1.0);
    stroke.view.eyeLps = stroke.view.targetLps - 200.0 * towards;
    do {
        stroke.view.up = randomDirection(random);
    } while (std::abs(glm::dot(stroke.view.up, towards)) > 0.95);
    stroke.mask.radiusMm = 0.5 + reach * 0.5 * randomUnit(random);
    stroke.depthMm = reach * randomUnit(random);
    stroke.pressureExponent = randomInt(random, 1, 3);
    stroke.surfaceThreshold = tissueCode / 2;
    stroke.throughGaps = random() % 3 == 0;
    double xMm = 0.0;
    double yMm = 0.0;
    for (int i = randomInt(random, 1, 5); i > 0; --i) {
        stroke.samples.push_back({.xMm = xMm, .yMm = yMm, .pressure = randomUnit(random)});
        xMm += (randomUnit(random) - 0.5) * reach;
        yMm += (randomUnit(random) - 0.5) * reach;
    }
    randomise(stroke, reach, random);
    stroke.hidden = randomHidden(document, random);
    if (!core::drillCut(stroke, document)) // too small a mask for these voxels
        stroke.mask = {.radiusMm = stroke.mask.radiusMm};
    return stroke;
}

core::DrillCut drillCutOf(const core::Edit& drill, const core::Document& document)
{
    auto cut = core::drillCut(drill.get<core::DrillStroke>(), document);
    if (!cut)
        throw std::invalid_argument(cut.error().arguments.join(QStringLiteral(": ")).toStdString());
    return *cut;
}

std::vector<core::DrillSample> drillSamplesOf(const core::Edit& drill, const core::DrillCut& cut)
{
    return core::drillPath(drill.get<core::DrillStroke>(), cut);
}

} // namespace test
