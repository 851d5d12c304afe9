// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/SightedTable.h"

#include <algorithm>

namespace reenact {

namespace {

/// As the issue of the table asks of the tools of the surface; a brush may take longer.
constexpr SightedPatience ofSurface{.mostActions = 12};
constexpr SightedPatience ofBrush{.mostActions = 40};

SightedOutcome outcomeOf(const SightedRun& run, const Truth& truth)
{
    const glm::ivec3 size = truth.plain.size;
    const Mask mask = maskOf(run.mask, size);
    SightedOutcome outcome{.after = truth.plainErrorOf(mask),
        .afterVoxelised = truth.errorOf(mask),
        .actions = run.actions(),
        .looks = run.looks,
        .seconds = run.seconds};
    for (const SightedRun::Step& step : run.steps) {
        outcome.errors.push_back(truth.plainErrorOf(maskOf(step.seen, size)));
        outcome.log
            << QStringLiteral("%1: %2 %").arg(step.what).arg(outcome.errors.back(), 0, 'f', 2);
    }
    return outcome;
}

} // namespace

const std::vector<SightedRow>& sightedRows()
{
    using enum TableRow::Fault;
    static const std::vector<SightedRow> rows = [] {
        std::vector<SightedRow> all;
        for (const TableRow& row : tableRows())
            all.push_back({.row = row});
        const auto further = [&all](const TableRow& row) {
            all.push_back({.row = row, .isOfPaper = false});
        };
        further({"2d", "liver, leak through the diaphragm", Organ::Liver, Leak, Organ::Lung,
            {0.0, 0.0, 1.0}, 4.0, 2.5, 0.0});
        further({"8a", "hip bone, crest missing", Organ::Hip, Cut, Organ::None, {0.0, 0.0, 1.0},
            12.0, 2.0, 0.0});
        further({"8b", "hip bone, leak into the femur", Organ::Hip, Leak, Organ::Femur,
            {0.0, 0.0, -1.0}, 12.0, 2.0, 0.0});
        further({"9", "portal vein, an end missing", Organ::PortalVein, Cut, Organ::None,
            {1.0, 0.0, 0.0}, 20.0, 3.0, 0.0});
        return all;
    }();
    return rows;
}

int SightedOutcome::actionsTo(double error) const
{
    const auto found =
        std::find_if(errors.begin(), errors.end(), [error](double left) { return left <= error; });
    return found == errors.end() ? 0 : int(found - errors.begin()) + 1;
}

SightedAttempt attemptSighted(const OrganScene& scene, const TableRow& row, const Truth& truth,
    double scale, std::uint64_t seed)
{
    const Corrupted poor = corrupted(scene, row, scale, seed);
    SightedAttempt made{.before = poor.error, .beforeVoxelised = truth.errorOf(poor.mask)};
    {
        RefinementBench bench(scene.study, poor.mask);
        Reader reader(scene.study, truth.plain, seed);
        made.surface = outcomeOf(runSightedSurfaceRobot(bench, reader, ofSurface, seed), truth);
    }
    {
        RefinementBench bench(scene.study, poor.mask);
        Reader reader(scene.study, truth.plain, seed);
        made.brush = outcomeOf(runSightedBrushRobot(bench, reader, ofBrush, seed), truth);
    }
    return made;
}

} // namespace reenact
