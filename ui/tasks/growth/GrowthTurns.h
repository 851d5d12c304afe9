// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {
struct Document;
struct GrowGuard;
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

/// A burst of growth: the segments that grow together, and their common interval (modality units).
struct GrowthTurn {
    /// Labels, ascending; none: all segments that are not locked (GrowCriteria::segments).
    std::optional<std::vector<int>> segments{};
    double lower = 0.0;
    double upper = 0.0;
    std::optional<int> plane{}; ///< the label plane that grows (GrowCriteria::plane)
    bool operator==(const GrowthTurn&) const = default;
};

/// Plans which segments grow, and in which order, so that none grows in another's interval:
/// - If all have the same interval, all grow together.
/// - Otherwise the active segment grows first; then those without voxels follow, each in its own
///   interval.
/// - Segments whose intervals have at least half of their union in common compete for the same
///   tissue. They grow together, in an interval that contains all of theirs, and continue together.
/// - A turn whose interval lies mostly within another's comes before it, since the other would
///   claim its seeds.
/// - Segments that have grown before in another interval stay as they are.
/// @param last the segments of the last growth (GrowCriteria::segments)
[[nodiscard]] std::vector<GrowthTurn> growthTurns(const std::vector<SeededSegment>& seeded,
    int active, const std::optional<std::vector<int>>& last);
/// The turns for the segments of the open session in the active one's label plane; at least one.
[[nodiscard]] std::vector<GrowthTurn> growthTurns(const Workspace& workspace);

/// The edit that grows a turn to closure, with the other settings of growth, within the editable
/// range.
[[nodiscard]] core::GrowSteps growthOf(const GrowthTurn& turn, const Workspace& workspace);

/// The labels of the segments that a growth in a label plane names (GrowCriteria::segments), or of
/// all that grow if it names none.
[[nodiscard]] std::vector<int> growingLabels(const std::optional<std::vector<int>>& segments,
    std::uint8_t plane, const Workspace& workspace);
/// Lets a growth in these segments ask only about fronts that are wider than those that the user
/// has accepted in all of them (AcceptedFronts.h).
void raiseGuard(core::GrowGuard& guard, const std::optional<std::vector<int>>& segments,
    std::uint8_t plane, const Workspace& workspace);
/// By how much a front must be wider if the next growth of the active segment is to ask about it,
/// because narrower ones were accepted; none: as in the settings.
[[nodiscard]] std::optional<double> raisedAreaMm2(const Workspace& workspace);

/// The segments whose growth changes with the active segment's interval: those that grew together
/// with it. None: all segments that are not locked.
[[nodiscard]] std::optional<std::vector<int>> followingSegments(const Workspace& workspace);

/// Sets the interval of the active segment for all segments that grew together with it.
void shareInterval(Workspace& workspace);

/// Whether the active segment grows in a turn.
[[nodiscard]] bool activeGrows(const GrowthTurn& turn, const Workspace& workspace);

/// The segment to which messages about a turn refer: the active one if it grew in the turn, or else
/// the only one of the turn; 0: neither.
[[nodiscard]] int grownIn(const GrowthTurn& turn, const Workspace& workspace);

/// Whether there are segments in a label plane and all of them are locked.
[[nodiscard]] bool everySegmentLocked(const core::Document& document, std::uint8_t plane);

/// A sentence that tells the user the order of the turns; empty if all segments grow together in
/// one interval.
[[nodiscard]] QString textOf(const std::vector<GrowthTurn>& turns, const Workspace& workspace);

} // namespace ui
