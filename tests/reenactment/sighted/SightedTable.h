// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/Corruptor.h"
#include "tests/reenactment/RefinementBench.h"
#include "tests/reenactment/sighted/SightedRobots.h"

namespace reenact {

/// The rows of the paper's table that the shared study has organs for, and such as it does not
/// have: a leak through the diaphragm, a hip bone, a portal vein. Those have no second error in the
/// paper; `after` only says how much the border trembles, by a fifth of it.
struct SightedRow {
    TableRow row;
    bool isOfPaper = true;
};
[[nodiscard]] const std::vector<SightedRow>& sightedRows();

/// What a robot came to, measured by those who hold the reference. rVE in per cent.
struct SightedOutcome {
    double after = 0.0; ///< against the organ
    double afterVoxelised = 0.0; ///< against the voxels in its first surface (seed B §7.3)
    int actions = 0;
    int looks = 0;
    double seconds = 0.0;
    std::vector<double> errors; ///< against the organ, of what was seen after each action
    QStringList log;

    /// The first action after which it was no more wrong than that; 0: it never was.
    [[nodiscard]] int actionsTo(double error) const;
};

struct SightedAttempt {
    double before = 0.0; ///< against the organ
    double beforeVoxelised = 0.0;
    SightedOutcome surface;
    SightedOutcome brush;
};
/// A mask is spoilt by the seed, and mended by either robot with the same eyes and hand.
[[nodiscard]] SightedAttempt attemptSighted(const OrganScene& scene, const TableRow& row,
    const Truth& truth, double scale, std::uint64_t seed);

} // namespace reenact
