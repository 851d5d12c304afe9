// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "tests/reenactment/BallStroke.h"
#include "tests/reenactment/sighted/PenHand.h"
#include "tests/reenactment/sighted/SightedRobots.h"
#include "tests/support/scenes/PlainEdits.h"

#include <algorithm>

using namespace core;

namespace reenact {

namespace {

constexpr double leastRadius = 1.2; ///< voxels
constexpr std::size_t regionsLookedAt = 4;
/// After so many strokes that did no good the user gives up.
constexpr int mostFailures = 3;

} // namespace

SightedRun runSightedBrushRobot(
    RefinementBench& bench, Reader& reader, const SightedPatience& patience, std::uint64_t seed)
{
    PenHand hand(bench.geometry(), seed);
    const Inspection inspection(reader, bench.geometry(), bench.seen());
    SightedLog log(bench, inspection);
    int failures = 0;
    while (log.actions() < patience.mostActions && failures < mostFailures) {
        const Mask meant = inspection.meant(log.seen());
        const UserEye eye(log.seen(), meant);
        const auto regions = eye.regions();
        BallStroke best;
        bool adds = false;
        for (std::size_t i = 0; i < std::min(regionsLookedAt, regions.size()); ++i) {
            BallStroke stroke = bestStroke(eye, regions[i], leastRadius);
            if (stroke.gain <= best.gain)
                continue;
            best = std::move(stroke);
            adds = regions[i].isMissing;
        }
        if (best.gain <= 0)
            break;
        const double radiusMm = hand.radiusMm(hand.mm(best.radius));
        Edit paint = adds ? test::paintAt(1, {}, radiusMm) : test::eraseAt(1, {}, radiusMm);
        brushPathOf(paint)->pointsLps =
            hand.drawnOnPlane(hand.lps(best.points), bench.geometry().direction()[best.axis]);
        const bool helped = log.act(paint,
            QStringLiteral("%1 r=%2 mm, %3 points")
                .arg(adds ? QStringLiteral("paint") : QStringLiteral("erase"))
                .arg(radiusMm, 0, 'f', 1)
                .arg(best.points.size()));
        failures = helped ? 0 : failures + 1;
    }
    return log.finished(reader.looks());
}

} // namespace reenact
