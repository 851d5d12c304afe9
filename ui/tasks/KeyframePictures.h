// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QCache>
#include <QImage>
#include <QObject>

#include <set>

namespace ui {

class Workspace;

/// The keyframes of the open session as pictures. They are fetched from the session's file when
/// they are first requested; the latest ones are kept in memory. Never waits.
class KeyframePictures : public QObject {
    Q_OBJECT

public:
    explicit KeyframePictures(Workspace& workspace, QObject* parent = nullptr);

    /// The row on @p line that has a picture and is nearest to index @p lineIndex, the earlier one
    /// of two; −1 if none has one.
    [[nodiscard]] core::RowId nearest(const std::vector<core::RowId>& line, int lineIndex) const;
    /// The picture of a row; null while it is fetched, or if it cannot be read.
    [[nodiscard]] QImage picture(core::RowId row);

Q_SIGNALS:
    void arrived(core::RowId row);

private:
    void forget();
    void take(core::RowId row, const QImage& picture);

    Workspace& m_workspace;
    QCache<core::RowId, QImage> m_pictures;
    std::set<core::RowId> m_asked; ///< rows requested and not arrived yet
    int m_session = 0; ///< number of the session; late pictures of an earlier one are dropped
};

} // namespace ui
