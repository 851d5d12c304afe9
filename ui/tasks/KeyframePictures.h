// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QCache>
#include <QImage>
#include <QObject>

#include <set>

namespace ui {

class Workspace;

/// The keyframes of the open session as pictures: fetched from its file when they are first asked
/// for, the last ones kept in memory. Never waits.
class KeyframePictures : public QObject {
    Q_OBJECT

public:
    explicit KeyframePictures(Workspace& workspace, QObject* parent = nullptr);

    /// The row on @p line whose picture is nearest to that of place @p lineIndex, the earlier of
    /// two; −1: none has one.
    [[nodiscard]] core::RowId nearest(const std::vector<core::RowId>& line, int lineIndex) const;
    /// Null while it is fetched, or where it cannot be read.
    [[nodiscard]] QImage picture(core::RowId row);

Q_SIGNALS:
    void arrived(core::RowId row);

private:
    void forget();
    void take(core::RowId row, const QImage& picture);

    Workspace& m_workspace;
    QCache<core::RowId, QImage> m_pictures;
    std::set<core::RowId> m_asked; ///< and not arrived yet
    int m_session = 0; ///< counts sessions: what comes late is another's
};

} // namespace ui
