// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/document/Document.h"
#include "core/history/History.h"
#include "ui/settings/KeyframeRule.h"

#include <QImage>
#include <QObject>

#include <functional>

namespace core {
struct DocumentChange;
}

namespace ui {

class ImageView;
class Workspace;

/// Stores pictures of the work (keyframes) in its session file: what a view shows, whenever
/// KeyframeRule wants one. It uses finished frames as they are; nothing is drawn for it, and
/// scaling and PNG encoding run on another thread.
class KeyframeRecorder : public QObject {
    Q_OBJECT

public:
    KeyframeRecorder(Workspace& workspace, ImageView& view);

    /// Sets a steady clock in milliseconds, in place of the machine's.
    void setClock(std::function<qint64()> clock) { m_clock = std::move(clock); }

private:
    void begin();
    void follow(const core::DocumentChange& change);
    void look();
    void close();
    /// Whether the picture shows the present state: it is newer than the last change of voxels.
    [[nodiscard]] bool showsPresentState() const;
    void keep(core::RowId row, const QImage& picture);

    Workspace& m_workspace;
    ImageView& m_view;
    std::function<qint64()> m_clock;
    std::size_t m_rows = 0; ///< number of history rows, as last seen
    core::RowId m_position = 0; ///< as last seen
    KeyframeRule m_rule;
    bool m_due = false;
    qint64 m_outdated = 0; ///< key of the picture that was shown when voxels last changed
    core::Background m_encoder; ///< last: it uses all of the above
};

} // namespace ui
