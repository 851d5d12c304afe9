// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/BrushRobot.h"

#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "tests/reenactment/BallStroke.h"
#include "tests/reenactment/RobotLog.h"
#include "tests/reenactment/UserHand.h"
#include "tests/support/scenes/PlainEdits.h"

#include <algorithm>

using namespace core;

namespace reenact {

RobotRun runBrushRobot(RefinementBench& bench, const Truth& truth, const RobotGoal& goal,
    BrushPath::Shape shape, std::uint64_t seed)
{
    const bool isDisc = shape == BrushPath::Shape::Disc;
    constexpr double leastRadius = 1.2;
    constexpr std::size_t mostRegions = 4;
    UserHand hand(bench.geometry(), seed);
    RobotLog log(bench, truth);
    Mask seen = bench.segment();
    while (log.error() > goal.error && log.actions() < goal.mostActions) {
        const UserEye eye(seen, truth.plain);
        const auto regions = eye.regions();
        BallStroke best;
        bool adds = false;
        for (std::size_t i = 0; i < std::min(mostRegions, regions.size()); ++i) {
            BallStroke stroke = bestStroke(eye, regions[i], leastRadius, isDisc);
            if (stroke.gain <= best.gain)
                continue;
            best = std::move(stroke);
            adds = regions[i].isMissing;
        }
        if (best.gain <= 0)
            break;
        const double radiusMm = hand.mm(best.radius);
        Edit paint = adds ? test::paintAt(1, {}, radiusMm) : test::eraseAt(1, {}, radiusMm);
        BrushPath& path = *brushPathOf(paint);
        path.shape = shape;
        if (isDisc) {
            // On the slice that is shown.
            glm::dvec3 normal(0.0);
            normal[best.axis] = 1.0;
            path.normalLps = bench.geometry().direction() * normal;
            path.pointsLps = hand.lps(hand.drawnOnPlane(best.points, normal));
        } else {
            path.pointsLps = hand.lps(hand.drawn(best.points));
        }
        const QString what = QStringLiteral("%1 r=%2, %3 points")
                                 .arg(adds ? QStringLiteral("paint") : QStringLiteral("erase"))
                                 .arg(best.radius)
                                 .arg(best.points.size());
        log.act(paint, what);
        seen = bench.segment();
    }
    return log.finished();
}

} // namespace reenact
