// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/lists/EyeRowDelegate.h"

namespace ui {

/// A row of the list of pieces: eye, name, how far it is from home. A click on the eye shows or
/// hides it.
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
