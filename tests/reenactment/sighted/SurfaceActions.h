// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/surface/parts/SurfacePath.h"
#include "tests/reenactment/BallStroke.h"
#include "tests/reenactment/ChunkStroke.h"
#include "tests/reenactment/ToolPlans.h"
#include "tests/reenactment/sighted/PenHand.h"
#include "tests/reenactment/sighted/SightedLog.h"

namespace reenact {

/// Carries out what was planned, with an unsteady hand. Each returns whether it did any good.
class SurfaceActions {
public:
    SurfaceActions(
        RefinementBench& bench, Inspection& inspection, SightedLog& log, std::uint64_t seed);

    bool divide(double marginMm);
    bool clickChunks(const ChunkStroke& stroke);
    bool lay();
    bool writeBack();

    /// @param eye to see from which side the ball has to come
    bool push(const UserEye& eye, const UserEye::Region& region, const BallStroke& stroke);
    bool scrape(const ScrapePlan& plan);
    bool drag(const DragPlan& plan);
    bool attract(const SweepPlan& plan);
    /// Opens the plane of each contour, and draws what it reads there.
    bool shape(const TemplatePlan& plan);

private:
    [[nodiscard]] core::SurfacePath pathOf(double radius, const std::vector<glm::dvec3>& points);
    [[nodiscard]] std::vector<glm::dvec3> asRead(const TemplatePlan::Contour& contour);

    RefinementBench& m_bench;
    Inspection& m_inspection;
    SightedLog& m_log;
    PenHand m_hand;
};

} // namespace reenact
