// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QByteArray>
#include <QImage>
#include <QSize>

#include <cstddef>

namespace ui {

/// When a picture of the work is wanted: after the first step of a session, then after every ten or
/// with the first one after a minute, and when the session is closed elsewhere than at the last
/// picture. The window and `burin run` keep to it.
class KeyframeRule {
public:
    static constexpr int stepsBetween = 10;
    static constexpr qint64 millisecondsBetween = 60'000;
    /// Pictures fit into it.
    static constexpr QSize pictureSize{256, 192};

    /// @param rows of the history; @param now milliseconds of a steady clock
    void begin(std::size_t rows, core::RowId position, bool anyPicture, qint64 now);
    /// A step was made. @return whether a picture is due
    [[nodiscard]] bool dueAfterStep(std::size_t rows, qint64 now) const;
    [[nodiscard]] bool dueAtEnd(core::RowId position) const;
    /// A picture of @p row was taken.
    void kept(core::RowId row, std::size_t rows, qint64 now);

private:
    std::size_t m_rowsAtLast = 0;
    qint64 m_timeAtLast = 0;
    core::RowId m_lastKept = -1;
    bool m_any = false; ///< the session has a picture
};

/// Milliseconds of the machine's steady clock.
[[nodiscard]] qint64 steadyMilliseconds();

/// A picture brought to KeyframeRule::pictureSize. Any thread.
[[nodiscard]] QByteArray keyframePng(const QImage& picture);

} // namespace ui
