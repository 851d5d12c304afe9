// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "ui/widgets/StepSlider.h"

#include <optional>

namespace ui {

class HistoryModel;
class KeyframePictures;
class KeyframePopup;
class Workspace;

/// The current line of the history as a slider, one step per row. While it is dragged it shows
/// where it stands, and the study follows as fast as it can: one short walk at a time, each to
/// where the handle is by then. When it is released, or moved by keys, the study goes there. Hidden
/// if there is nothing to choose between. Above the step under the pointer or the handle floats its
/// name with the nearest keyframe.
class HistoryTimeline : public StepSlider {
    Q_OBJECT

public:
    HistoryTimeline(Workspace& workspace, const HistoryModel& model, QWidget* parent = nullptr);

    /// Sets whether there is room for it.
    void setRoom(bool room);
    /// Whether the handle stands at a step that the study has not reached yet.
    [[nodiscard]] bool isScrubbing() const { return m_wanted.has_value(); }

    [[nodiscard]] const KeyframePopup& popup() const { return *m_popup; }

Q_SIGNALS:
    /// The handle was moved to this place on the current line.
    void scrubbed(int lineIndex);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void want(int lineIndex);
    void finish();
    void follow();
    /// Walks on towards the wanted row, unless a walk is still under way.
    void advance();
    void walkTo(core::RowId row);
    void giveUp();
    void showStep(int lineIndex);
    void showPopup(int lineIndex);
    void hidePopup();
    [[nodiscard]] core::RowId nextTowards(core::RowId wanted) const;
    [[nodiscard]] int lineIndexOf(core::RowId row) const; ///< −1 if not on the current line

    Workspace& m_workspace;
    const HistoryModel& m_model;
    KeyframePictures* m_pictures = nullptr;
    KeyframePopup* m_popup = nullptr;
    int m_pointedAt = -1; ///< index on the line for which the popup is shown; −1: hidden
    bool m_room = true;
    std::optional<core::RowId> m_wanted;
    std::optional<core::RowId> m_walkingTo;
};

} // namespace ui
