// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/SurfaceCases.h"

#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"

#include <algorithm>

namespace test {

core::VoxelRuns ballRuns(const glm::ivec3& size, double radius)
{
    core::VoxelRuns runs;
    const glm::dvec3 middle = (glm::dvec3(size) - 1.0) / 2.0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 off = glm::dvec3(x, y, z) - middle;
                if (glm::dot(off, off) <= radius * radius)
                    runs.append(std::uint64_t((z * size.y + y) * size.x + x), 1);
            }
        }
    }
    return runs;
}

core::Edit ballMask(const glm::ivec3& size, double radius)
{
    return maskImport(QStringLiteral("ball.nrrd"), size,
        {{QStringLiteral("Ball"), ballRuns(size, radius), 0x4080C0}});
}

std::vector<StrokeCase> surfaceCases()
{
    const core::LoadedVolume volume = smallStudy();
    const core::VolumeGeometry& geometry = volume.volume.geometry;
    const glm::dvec3 middle = (glm::dvec3(geometry.size) - 1.0) / 2.0;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double voxelMm = std::min({spacing.x, spacing.y, spacing.z});
    const auto at = [&](const glm::dvec3& off) { return geometry.toWorld(middle + off); };

    const core::Edit ball = ballMask(geometry.size, 9.0);
    const core::Edit lay = core::LaySurface{.segment = 1, .vertices = 600};
    const core::Edit red = core::MarkSurface{.mark = core::SurfaceMark::Red,
        .path = {.radiusMm = 5.0 * voxelMm, .pointsLps = {at({9, 0, 0}), at({7, 5, 0})}}};
    const core::Edit green = core::MarkSurface{.mark = core::SurfaceMark::Green,
        .path = {.radiusMm = 4.0 * voxelMm, .pointsLps = {at({-9, 0, 0})}}};
    const core::Edit push =
        core::SpherePush{.path = {.radiusMm = 4.0 * voxelMm,
                             .pointsLps = {at({7, 0, 0}), at({9, 0, 0}), at({10, 1, 0})}}};
    const core::Edit scrape = core::PlaneScrape{
        .path = {.radiusMm = 5.0 * voxelMm, .pointsLps = {at({7, 0, 0}), at({7, 2, 0})}},
        .normalLps = geometry.direction()[0]};
    const core::Edit drag = core::PointDrag{
        .path = {.radiusMm = 5.0 * voxelMm, .pointsLps = {at({9, 0, 0}), at({11, 0, 0})}}};
    const core::Edit smooth =
        core::SmoothSurface{.path = {.radiusMm = 5.0 * voxelMm, .pointsLps = {at({9, 0, 0})}}};
    const core::Edit attract = core::AttractSurface{
        .path = {.radiusMm = 5.0 * voxelMm, .pointsLps = {at({9, 0, 0}), at({8, 3, 0})}}};
    const core::Edit shape =
        core::ApplyTemplate{.contoursLps = {{at({7, -4, 0}), at({11, 0, 0}), at({7, 4, 0})}}};
    const core::Edit write = core::WriteBack{};
    const core::Edit paint = test::paintAt(1, {at({0, 10, 0})}, 3.0 * voxelMm);
    const core::Edit locked = test::lockSegment(2);
    const core::Edit beside = ballMask(geometry.size, 12.0);

    std::vector<StrokeCase> cases;
    const auto add = [&](const char* name, std::vector<core::Edit> before, core::Edit edit) {
        cases.push_back({name, volume, std::move(before), std::move(edit)});
    };
    add("lay a surface", {ball}, lay);
    add("lay a surface anew", {ball, lay, push}, core::LaySurface{.segment = 1, .vertices = 900});
    // The mesh comes out as it was, in whole or in the piece that was there already.
    add("lay a surface again", {ball, lay}, lay);
    const core::Edit measured = core::LaySurface{.segment = 1, .vertices = 0};
    const core::Edit piece = test::paintAt(1, {at({14, 14, 0})}, 2.0 * voxelMm);
    add("lay a surface again beside a new piece", {ball, measured, piece}, measured);
    add("mark", {ball, lay}, red);
    add("mark green", {ball, lay, red}, green);
    add("grow marks", {ball, lay, red},
        core::ChangeMarks{.mark = core::SurfaceMark::Red, .way = core::ChangeMarks::Way::Grow});
    add("invert marks", {ball, lay, green},
        core::ChangeMarks{.mark = core::SurfaceMark::Green, .way = core::ChangeMarks::Way::Invert});
    const core::ChangeMarks accept{
        .mark = core::SurfaceMark::Red, .way = core::ChangeMarks::Way::Accept};
    core::ChangeMarks acceptOne = accept;
    acceptOne.nearLps = at({9, 0, 0});
    const core::Edit redToo = core::MarkSurface{.mark = core::SurfaceMark::Red,
        .path = {.radiusMm = 4.0 * voxelMm, .pointsLps = {at({-9, 0, 0})}}};
    core::ChangeMarks clearOne = acceptOne;
    clearOne.way = core::ChangeMarks::Way::Clear;
    add("sign off all errors", {ball, lay, red, redToo}, accept);
    add("sign off one error", {ball, lay, red, redToo}, acceptOne);
    add("clear one region", {ball, lay, red, redToo}, clearOne);
    add("push with a sphere", {ball, lay, red}, push);
    add("push yellow", {ball, lay}, push);
    auto firmer = push.get<core::SpherePush>();
    firmer.path.pressures = std::vector<double>{0.3, 0.7, 1.0};
    add("push as the pen is pressed", {ball, lay, red}, firmer);
    auto wider = core::PointDrag{.path = {.radiusMm = 5.0 * voxelMm,
                                     .pointsLps = {at({9, 0, 0}), at({10, 0, 0}), at({11, 0, 0})},
                                     .pressures = std::vector<double>{0.2, 0.6, 1.0}}};
    add("drag as the pen is pressed", {ball, lay, red}, wider);
    wider.path.rules = core::newestSurfaceRules;
    add("drag apart as the pen is pressed", {ball, lay, red}, wider);
    add("scrape", {ball, lay, red}, scrape);
    add("drag", {ball, lay, red}, drag);
    add("smooth", {ball, lay, red, push}, smooth);
    add("attract", {ball, lay, red}, attract);
    add("template", {ball, lay, red}, shape);
    add("write back", {ball, lay, red, push}, write);
    add("write back what was not changed", {ball, lay}, write);
    add("write back beside others", {ball, beside, lay, red, push}, write);
    add("write back over others", {ball, beside, lay, red, push},
        core::WriteBack{.overwriteUnlocked = true});
    add("write back beside locked ones", {ball, beside, locked, lay, red, push},
        core::WriteBack{.overwriteUnlocked = true});
    add("write back a second time", {ball, lay, red, push, write}, write);
    add("write back a second push", {ball, lay, red, push, write, scrape}, write);
    add("write back what was painted", {ball, lay, paint}, write);
    add("write back a push after painting", {ball, lay, push, paint}, write);
    add("write back after following the mask", {ball, lay, push, paint, core::FollowMask{}}, write);
    add("write back over others what they kept", {ball, beside, lay, red, push, core::WriteBack{}},
        core::WriteBack{.overwriteUnlocked = true});
    const core::Edit within =
        core::WriteBack{.editable = core::EditableRange{
                            .box = core::GrowBox{at({-30, -30, -30}), at({8, 30, 30})}}};
    add("write back within limits", {ball, lay, red, push}, within);
    add("write back what limits had kept", {ball, lay, red, push, within}, write);
    add("push after writing back", {ball, lay, red, push, write}, scrape);
    add("follow the mask", {ball, lay, red, push, paint}, core::FollowMask{});
    add("follow what did not change", {ball, lay}, core::FollowMask{});
    add("remove the surface", {ball, lay, push}, core::DropSurface{});
    add("delete the segment of a surface", {ball, lay, push}, core::RemoveSegment{.segment = 1});
    const core::Edit shut = core::SurfaceBarrier{};
    const core::Edit opened = core::SurfaceBarrier{.erase = true};
    const core::Edit seeds = test::seedAt(1, {at({0, 0, 0})});
    const core::Edit grow = test::growBy(
        {.lower = -2000, .upper = 4000, .connectivity = 26, .overwriteUnlocked = true});
    add("barrier around the surface", {ball, lay, push}, shut);
    add("barrier around the surface again", {ball, lay, push, shut}, shut);
    add("barrier around the surface through what has grown", {ball, beside, seeds, grow, lay, push},
        shut);
    add("growth within the surface", {ball, beside, lay, push, seeds, shut}, grow);
    add("open barrier around the surface", {ball, lay, push, seeds, shut, grow}, opened);
    add("open no barrier around the surface", {ball, lay, push}, opened);
    add("growth out of an opened surface", {ball, lay, push, seeds, shut, grow, opened},
        core::ResumeGrowth{});
    add("paint beside a surface", {ball, lay, push}, paint);
    core::PointDrag through{.path = {.radiusMm = 4.0 * voxelMm, .pointsLps = {}}};
    for (double x = 9.0; x >= -13.0; x -= 2.0)
        through.path.pointsLps.push_back(at({x, 0, 0}));
    const core::Edit anew = core::LaySurface{.segment = 1, .onlyCrossings = true};
    add("lay crossing parts anew", {ball, lay, red, through}, anew);
    add("lay crossing parts anew where none cross", {ball, lay, push}, anew);
    return cases;
}

} // namespace test
