// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/lists/EyeRowDelegate.h"

namespace ui {

/// Draws a row of the list of pieces: eye, name, and its distance from its true place. A click on
/// the eye shows or hides the piece.
class PieceDelegate : public EyeRowDelegate {
    Q_OBJECT

public:
    using EyeRowDelegate::EyeRowDelegate;

protected:
    [[nodiscard]] Row row(const QModelIndex& index) const override;
    [[nodiscard]] int stateWidth() const override { return 116; }
    void eyeClicked(QAbstractItemModel& model, const QModelIndex& index,
        Qt::KeyboardModifiers modifiers) override;
};

} // namespace ui
