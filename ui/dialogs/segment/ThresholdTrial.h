// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/values/ThresholdSegment.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace ui {

class Workspace;

/// Shows in all views what a threshold would make of its segment, before it is a step: the edit
/// stands open, and is begun anew when another one is wanted. If wishes arrive faster than that,
/// only the latest one is followed. Whatever else is done takes the trial back.
class ThresholdTrial : public QObject {
    Q_OBJECT

public:
    explicit ThresholdTrial(Workspace& workspace, QObject* parent = nullptr);

    /// Follows soon. An edit that is refused is not shown.
    void show(const core::ThresholdSegment& edit);
    /// Everything is as it was.
    void drop();
    /// Makes it a step; what is shown already is not worked out again. The workspace tells what it
    /// did, or why it cannot be.
    void take(const core::ThresholdSegment& edit);

private:
    void begin();
    [[nodiscard]] bool isOpen() const;

    Workspace& m_workspace;
    std::optional<core::ThresholdSegment> m_wanted;
    std::optional<core::ThresholdSegment> m_shown; ///< if it is open still
    QTimer m_soon;
};

} // namespace ui
