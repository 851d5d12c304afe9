// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/values/ThresholdSegment.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace ui {

class Workspace;

/// Previews a threshold in all views before it becomes a step of the history. The preview is an
/// open edit of the session; for another interval it is rolled back and begun again. If requests
/// arrive faster than that, only the latest one is shown. Any other edit takes the preview back.
class ThresholdTrial : public QObject {
    Q_OBJECT

public:
    explicit ThresholdTrial(Workspace& workspace, QObject* parent = nullptr);

    /// Requests the preview of @p edit; it appears a moment later. Nothing is shown for an edit
    /// that the session refuses.
    void show(const core::ThresholdSegment& edit);
    /// Ends the preview; all voxels are as before.
    void drop();
    /// Carries @p edit out as a step. If it is the one that is previewed, the open edit is
    /// committed and nothing is computed again. The workspace tells the user the result or the
    /// reason of a refusal.
    void take(const core::ThresholdSegment& edit);

private:
    void begin();
    [[nodiscard]] bool isOpen() const;

    Workspace& m_workspace;
    std::optional<core::ThresholdSegment> m_wanted;
    /// The edit that was begun; it may have been ended by another one since.
    std::optional<core::ThresholdSegment> m_shown;
    QTimer m_soon;
};

} // namespace ui
