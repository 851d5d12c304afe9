// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/history/History.h"
#include "ui/settings/growth/GrowSettings.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

/// The fronts of growth of which the user has said, after a leak alarm, that they are no leak. A
/// front that is hardly wider is no leak either, so growth in their segments raises the alarm again
/// only where a front gets wider by twice the area of the widest accepted one. This needs areas:
/// growths whose fronts are measured by counting voxels are not affected.
///
/// A front is forgotten when what has grown since is taken back to it, wholly (undo, shrinking) or
/// in part (*Shrink here*); when its segment gets new seeds or is removed; and when the user
/// changes the leak guard. Accepted fronts are not stored in the session: after it is opened again,
/// the first alarm is raised as if none had been accepted.
class AcceptedFronts {
public:
    /// To be called when another session is opened.
    void clear() { m_fronts.clear(); }
    /// To be called when segments or the history have changed.
    void follow(const core::EditSession& session);
    /// To be called when the settings have changed.
    void follow(const GrowSettings& settings);

    /// To be called before the growth goes on.
    /// @param plane the label plane of the growth
    /// @param labels the segments that grew
    void accept(const core::LeakAlarm& alarm, std::uint8_t plane, const std::vector<int>& labels,
        const core::EditSession& session);
    void forget(const std::vector<int>& labels);

    [[nodiscard]] bool isEmpty() const { return m_fronts.empty(); }
    /// How much wider than the narrow place a front must be to raise an alarm in these segments; 0:
    /// what the settings say, because in one of them nothing was accepted.
    [[nodiscard]] double areaMm2(const std::vector<int>& labels) const;

private:
    struct Front {
        int label = 0;
        std::uint8_t plane = 0;
        std::uint32_t generation = 0;
        double areaMm2 = 0.0; ///< that the next one must be wider by
        core::RowId row = 0; ///< of the growth that raised the alarm
        std::size_t rows = 0; ///< the number of the history's rows with it
    };

    [[nodiscard]] static bool holds(const Front& front, const std::vector<core::RowId>& standing,
        const core::EditSession& session);

    std::vector<Front> m_fronts;
    /// The leak guard as the user has set it.
    std::pair<GrowSettings::Limit, double> m_guard{
        GrowSettings().guard, GrowSettings().guardAreaMm2};
};

} // namespace ui
