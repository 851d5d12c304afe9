// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/strokes/RandomStrokes.h"

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "tests/support/cases/growth/GrowthAnswers.h"
#include "tests/support/cases/strokes/StrokeScene.h"
#include "tests/support/scenes/CutEdits.h"

#include <array>
#include <optional>
#include <utility>

namespace test {

namespace {

/// Limits beside the interval, any of them or none.
void addRandomLimits(
    core::GrowCriteria& criteria, const core::VolumeGeometry& geometry, Random& random)
{
    const auto maybe = [&random](double greatest) {
        return random() % 4 ? std::nullopt : std::optional(greatest * randomUnit(random));
    };
    if (random() % 4 == 0)
        criteria.sigmas = randomInt(random, 1, 1500) / 256.0;
    if (criteria.sigmas && int(*criteria.sigmas * 256.0) % 2 == 0)
        criteria.perStroke = true;
    criteria.difference = maybe(tissueCode);
    criteria.gradient = maybe(tissueCode);
    criteria.gradientDifference = maybe(tissueCode);
    if (random() % 4 == 0)
        criteria.majority = randomInt(random, 1, 20);
    criteria.onlyVisible = random() % 3 == 0;
    if (random() % 4 == 0)
        criteria.box =
            core::GrowBox{geometry.toWorld(glm::dvec3(randomVoxel(random, geometry.size))),
                geometry.toWorld(glm::dvec3(randomVoxel(random, geometry.size)))};
    if (random() % 4 == 0)
        criteria.passage = 6.0 * randomUnit(random) * geometry.spacingMm()[int(random() % 3)];
    if (random() % 4 == 0)
        criteria.smoothing = random() % 4 != 0;
}

core::GrowSteps randomGrowth(const core::Document& document, Random& random)
{
    core::GrowSteps grow;
    grow.criteria.lower = randomInt(random, 0, tissueCode / 2);
    grow.criteria.upper = randomInt(random, tissueCode / 2, tissueCode);
    grow.criteria.overwriteUnlocked = random() % 2;
    if (random() % 2)
        grow.steps = randomInt(random, 1, 12);
    grow.criteria.connectivity =
        std::array<int, 3>{6, 18, 26}[std::size_t(grow.criteria.upper) % 3];
    // Of a generator of their own: older cases stay as they are.
    Random limits(std::uint32_t(grow.criteria.lower * 1009.0 + grow.criteria.upper));
    if (limits() % 2)
        addRandomLimits(grow.criteria, document.volumes.front().geometry, limits);
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    // By value alone: segments that it lists may be gone.
    if (limits() % 4 == 0)
        grow.criteria.editable.emplace().lower = randomInt(limits, 0, tissueCode / 2);
    answerAsDaily(grow.criteria,
        {geometry.toWorld(glm::dvec3(geometry.size / 9)),
            geometry.toWorld(glm::dvec3(geometry.size - 2))},
        geometry.spacingMm().x);
    return grow;
}

/// A session that adds, mutes and deletes between its strokes; the last edit is the one in hand.
StrokeCase randomLists(int number)
{
    Random random(std::uint32_t(3700 + number));
    const glm::ivec3 extent{
        randomInt(random, 3, 40), randomInt(random, 3, 40), randomInt(random, 3, 30)};
    const core::Document scene = randomDocument(extent, random, number % 2);
    StrokeCase made{"random lists " + QByteArray::number(number),
        loaded(scene, number % 3 ? balls(extent, 5, random) : shells(extent)),
        {segmentNamed("First"), segmentNamed("Second"), segmentNamed("Third"),
            core::AddLayer{.name = QStringLiteral("Other")}},
        {}};
    std::vector<int> segments{1, 2, 3};
    int bookmarks = 0;
    int removed = 0; // of the bookmarks, the first so many
    std::array<bool, 3> muted{};
    for (int i = randomInt(random, 6, 14); i > 0; --i) {
        const int layer = randomInt(random, 1, 2);
        switch (random() % 9) {
        case 0:
        case 1:
            if (!segments.empty())
                made.before.push_back(
                    randomSeeds(scene, segments[random() % segments.size()], random));
            break;
        case 2:
            made.before.push_back(randomGrowth(scene, random));
            break;
        case 3:
            muted[std::size_t(layer)] = !muted[std::size_t(layer)];
            made.before.push_back(
                core::ChangeLayer{.layer = layer, .muted = muted[std::size_t(layer)]});
            break;
        case 4:
            if (!segments.empty()) {
                const auto which = segments.begin() + std::ptrdiff_t(random() % segments.size());
                made.before.push_back(core::RemoveSegment{.segment = *which});
                segments.erase(which);
            }
            break;
        case 5:
            made.before.push_back(bookmarkOf(randomDrill(scene, random)));
            ++bookmarks;
            break;
        case 6:
            if (bookmarks > removed)
                made.before.push_back(core::RemoveBookmark{.bookmark = ++removed});
            break;
        default: {
            const core::Edit stroke = drillWith({.layer = layer}, randomDrill(scene, random));
            if (!muted[std::size_t(layer)])
                made.before.push_back(stroke);
            break;
        }
        }
    }
    made.edit = made.before.back();
    made.before.pop_back();
    return made;
}

core::Edit randomEdit(const core::Document& document, Random& random)
{
    switch (random() % 10) {
    case 9: {
        core::LaserStroke stroke = randomLaser(document, random);
        stroke.layer = 1;
        return stroke;
    }
    case 0:
        return randomSeeds(document, randomInt(random, 1, 2), random);
    case 5: {
        core::PeelCut peel = randomPeel(document, random);
        peel.layer = 1;
        return peel;
    }
    case 6: {
        core::ScissorsCut cut = randomScissors(document, random);
        cut.layer = 1;
        return cut;
    }
    case 1:
    case 2:
        return randomGrowth(document, random);
    case 3: {
        core::Document segmented = document;
        segmented.segments = {{.label = 1}, {.label = 2}};
        return randomPaint(segmented, random);
    }
    case 4: {
        core::BrushStroke stroke = randomBrush(document, random);
        stroke.layer = 1;
        return stroke;
    }
    default:
        // The layer that a session begins with.
        return drillWith({.layer = 1}, randomDrill(document, random));
    }
}

} // namespace

core::Edit randomSeeds(const core::Document& document, int segment, Random& random)
{
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    core::SeedStroke seeds{segment, {}};
    for (int i = randomInt(random, 1, 6); i > 0; --i) {
        const glm::dvec3 jitter(0.4 * randomUnit(random));
        seeds.pointsLps.push_back(
            geometry.toWorld(glm::dvec3(randomVoxel(random, geometry.size)) + jitter));
    }
    return seeds;
}

void addRandomStrokes(std::vector<StrokeCase>& cases, int count)
{
    const core::Edit first = segmentNamed("First");
    const core::Edit second = segmentNamed("Second");
    for (int number = 0; number < count; ++number)
        cases.push_back(randomLists(number));
    for (int number = 0; number < count; ++number) {
        Random own(std::uint32_t(700 + number));
        const glm::ivec3 extent{
            randomInt(own, 3, 40), randomInt(own, 3, 40), randomInt(own, 3, 30)};
        const core::Document scene = randomDocument(extent, own, number % 2);
        StrokeCase made{"random stroke " + QByteArray::number(number),
            loaded(scene, number % 3 ? balls(extent, 5, own) : shells(extent)),
            {first, second, randomSeeds(scene, 1, own)}, randomEdit(scene, own)};
        for (int i = randomInt(own, 0, 3); i > 0; --i)
            made.before.push_back(randomEdit(scene, own));
        cases.push_back(std::move(made));
    }
}

} // namespace test
