// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/history/History.h"
#include "core/session/past/SketchedSeeds.h"

#include <optional>
#include <vector>

namespace core {

class SessionState;

/// What steps that were carried out since the session was opened found besides what their rows
/// tell. Part of EditSession.
class StepFindings {
public:
    explicit StepFindings(const SessionState& state);

    /// Later strokes that started on the surface that the last ReviseStroke changed: they stay
    /// where they are. Empty unless that edit is the position.
    [[nodiscard]] std::vector<RowId> strokesOnRevisedSurface() const;
    /// What the guard suspected of the growth that is the position; none of other steps.
    [[nodiscard]] std::optional<LeakAlarm> leakAlarm() const;
    /// What became of the places of the last SeedStroke, whether it left a row or changed nothing.
    [[nodiscard]] const std::optional<SketchedSeeds>& sketchedSeeds() const;

private:
    const SessionState& m_state;
};

} // namespace core
