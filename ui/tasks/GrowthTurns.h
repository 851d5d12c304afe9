// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace core {
struct Document;
struct GrowSteps;
} // namespace core

namespace ui {

class Workspace;
struct GrowSettings;

/// A segment that has seeds and is not locked.
struct SeededSegment {
    int label = 0;
    double lower = 0.0; ///< its interval, modality units
    double upper = 0.0;
    bool isFresh = true; ///< it has no voxels yet
};

/// Segments that grow together, in one interval.
struct GrowthTurn {
    /// ascending; none: all that are not locked (GrowCriteria::segments)
    std::optional<std::vector<int>> segments{};
    double lower = 0.0;
    double upper = 0.0;
    bool operator==(const GrowthTurn&) const = default;
};

/// Which segments grow when the user lets them, so that none grows in the interval of another.
///
/// If all have the same interval, all grow together. Otherwise the active one begins, and those
/// that have no voxels yet follow, one after the other, each in its own interval. Segments whose
/// intervals have at least half in common compete for the same tissue: they grow together, in an
/// interval that holds those of each, and go on together. One whose interval lies mostly within
/// another's grows before it, since the other would claim its seeds. What has grown in another
/// interval stays as it is.
/// @param last the segments of the last growth (GrowCriteria::segments)
[[nodiscard]] std::vector<GrowthTurn> growthTurns(const std::vector<SeededSegment>& seeded,
    int active, const std::optional<std::vector<int>>& last);
/// The same for the segments of the session; at least one turn.
[[nodiscard]] std::vector<GrowthTurn> growthTurns(const Workspace& workspace);

/// The growth of a turn, to closure, by everything else that is set.
[[nodiscard]] core::GrowSteps growthOf(const GrowthTurn& turn, const GrowSettings& settings);

/// The segments whose growth follows when the interval of the active one is changed: those that
/// grew together with it; none: all that are not locked.
[[nodiscard]] std::optional<std::vector<int>> followingSegments(const Workspace& workspace);

/// Gives the interval of the active segment to those whose growth follows with it.
void shareInterval(Workspace& workspace);

/// Whether a segment grows in a turn.
[[nodiscard]] bool grows(const GrowthTurn& turn, int label);

/// The segment that a turn has grown: the active one if it is of the turn and has seeds, or else
/// the only one of the turn; 0: neither.
[[nodiscard]] int grownIn(const GrowthTurn& turn, const Workspace& workspace);

/// Whether there are segments, and none may grow.
[[nodiscard]] bool everySegmentLocked(const core::Document& document);

/// What the user is told of the turns; empty where all grow together in one interval.
[[nodiscard]] QString textOf(const std::vector<GrowthTurn>& turns, const Workspace& workspace);

} // namespace ui
