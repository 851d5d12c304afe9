// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/history/History.h"
#include "core/session/past/SketchedSeeds.h"

#include <optional>
#include <vector>

namespace core {

class SessionState;

/// What the steps carried out since the session was opened found, in addition to what their rows
/// say. Part of EditSession.
class StepFindings {
public:
    explicit StepFindings(const SessionState& state);

    /// Later strokes that started on the surface that the last ReviseStroke changed. They stay
    /// where they are. Empty unless that edit is the current position.
    [[nodiscard]] std::vector<RowId> strokesOnRevisedSurface() const;
    /// The leak that the guard suspects in the growth at the current position; none for other
    /// steps.
    [[nodiscard]] std::optional<LeakAlarm> leakAlarm() const;
    /// What the voxels of the last SeedStroke became, whether or not it left a row.
    [[nodiscard]] const std::optional<SketchedSeeds>& sketchedSeeds() const;

private:
    const SessionState& m_state;
};

} // namespace core
