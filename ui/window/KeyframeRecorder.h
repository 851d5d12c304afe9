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

/// Keeps pictures of the work in its session file: of what a view shows, when KeyframeRule wants
/// one. It takes finished frames as they are; nothing is drawn for it, and scaling and PNG are a
/// worker's.
class KeyframeRecorder : public QObject {
    Q_OBJECT

public:
    KeyframeRecorder(Workspace& workspace, ImageView& view);

    /// Milliseconds of some steady clock; until it is set, the machine's.
    void setClock(std::function<qint64()> clock) { m_clock = std::move(clock); }

private:
    void begin();
    void follow(const core::DocumentChange& change);
    void look();
    void close();
    /// The picture is one of the present state: newer than the last change of voxels.
    [[nodiscard]] bool showsPresentState() const;
    void keep(core::RowId row, const QImage& picture);

    Workspace& m_workspace;
    ImageView& m_view;
    std::function<qint64()> m_clock;
    std::size_t m_rows = 0; ///< of the history, as last seen
    core::RowId m_position = 0; ///< as last seen
    KeyframeRule m_rule;
    bool m_due = false;
    qint64 m_outdated = 0; ///< the picture that was shown when voxels last changed
    core::Background m_encoder; ///< last: it uses all of the above
};

} // namespace ui
