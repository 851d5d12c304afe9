// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QByteArray>
#include <QImage>
#include <QSize>

#include <cstddef>

namespace ui {

/// The rule for when a picture (keyframe) of the 3D view is stored in the session: after the first
/// step, then after every ten steps or with the first step after a minute, and on closing unless
/// the position is that of the last picture. The window and `burin run` both use it.
class KeyframeRule {
public:
    static constexpr int stepsBetween = 10;
    static constexpr qint64 millisecondsBetween = 60'000;
    /// Pictures are scaled to fit this size.
    static constexpr QSize pictureSize{256, 192};

    /// @param rows number of rows in the history
    /// @param now milliseconds of a steady clock
    void begin(std::size_t rows, core::RowId position, bool anyPicture, qint64 now);
    /// To be called after a step.
    /// @return whether a picture is due
    [[nodiscard]] bool dueAfterStep(std::size_t rows, qint64 now) const;
    [[nodiscard]] bool dueAtEnd(core::RowId position) const;
    /// Records that a picture of @p row was taken.
    void kept(core::RowId row, std::size_t rows, qint64 now);

private:
    std::size_t m_rowsAtLast = 0;
    qint64 m_timeAtLast = 0;
    core::RowId m_lastKept = -1;
    bool m_any = false; ///< the session has a picture
};

/// The machine's steady clock, in milliseconds.
[[nodiscard]] qint64 steadyMilliseconds();

/// A picture scaled to KeyframeRule::pictureSize, as PNG. Any thread.
[[nodiscard]] QByteArray keyframePng(const QImage& picture);

} // namespace ui
