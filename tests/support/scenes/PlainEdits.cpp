// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/PlainEdits.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/values/ThresholdSegment.h"

#include <utility>

namespace test {

core::Edit newSegment(const QString& name, std::uint32_t rgb)
{
    return core::AddSegment{.name = name, .rgb = rgb};
}

core::Edit renameSegment(int segment, const QString& name)
{
    return core::ChangeSegment{.segment = segment, .name = name};
}

core::Edit lockSegment(int segment, bool locked)
{
    return core::ChangeSegment{.segment = segment, .locked = locked};
}

core::Edit protectSegment(int segment, bool isProtected)
{
    return core::ChangeSegment{.segment = segment, .uncarvable = isProtected};
}

core::Edit seedAt(int segment, std::vector<glm::dvec3> pointsLps)
{
    return core::SeedStroke{.segment = segment, .pointsLps = std::move(pointsLps)};
}

core::Edit growBetween(double lower, double upper, std::optional<int> steps)
{
    return growBy({.lower = lower, .upper = upper}, steps);
}

core::Edit growBy(const core::GrowCriteria& criteria, std::optional<int> steps)
{
    return core::GrowSteps{.criteria = criteria, .steps = steps};
}

core::Edit paintAt(int segment, std::vector<glm::dvec3> pointsLps, double radiusMm)
{
    return core::PaintStroke{
        .segment = segment, .path = {.radiusMm = radiusMm, .pointsLps = std::move(pointsLps)}};
}

core::Edit paintDiscAt(
    int segment, const glm::dvec3& pointLps, const glm::dvec3& normalLps, double radiusMm)
{
    return core::PaintStroke{.segment = segment,
        .path = {.radiusMm = radiusMm,
            .shape = core::BrushPath::Shape::Disc,
            .normalLps = normalLps,
            .pointsLps = {pointLps}}};
}

core::Edit paintSeedsAt(int segment, std::vector<glm::dvec3> pointsLps, double radiusMm)
{
    return core::PaintStroke{.segment = segment,
        .path = {.radiusMm = radiusMm, .pointsLps = std::move(pointsLps)},
        .seeds = true};
}

core::Edit paintAlongEdgesAt(
    int segment, std::vector<glm::dvec3> pointsLps, double radiusMm, double tolerance)
{
    return core::PaintStroke{.segment = segment,
        .path = {.radiusMm = radiusMm, .pointsLps = std::move(pointsLps)},
        .edgeTolerance = tolerance};
}

core::Edit paintOverAt(int segment, std::vector<glm::dvec3> pointsLps, double radiusMm)
{
    return core::PaintStroke{.segment = segment,
        .path = {.radiusMm = radiusMm, .pointsLps = std::move(pointsLps)},
        .overwriteUnlocked = true};
}

core::Edit eraseAt(int segment, std::vector<glm::dvec3> pointsLps, double radiusMm)
{
    return core::PaintStroke{.segment = segment,
        .path = {.radiusMm = radiusMm, .pointsLps = std::move(pointsLps)},
        .erase = true};
}

core::Edit carveAt(std::vector<glm::dvec3> pointsLps, double radiusMm)
{
    return core::BrushStroke{.path = {.radiusMm = radiusMm, .pointsLps = std::move(pointsLps)}};
}

core::Edit thresholdOf(int segment, double lower, std::optional<double> upper)
{
    return core::ThresholdSegment{.segment = segment, .lower = lower, .upper = upper};
}

core::Edit revertRows(std::vector<std::int64_t> rows)
{
    return core::RevertRows{std::move(rows)};
}

} // namespace test
