// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/lists/EyeRowDelegate.h"

namespace ui {

/// Draws a row of the list of sculpt layers: eye, name, and its present effect. A click on the eye
/// mutes or unmutes the layer; with Ctrl only this layer counts (solo).
class LayerDelegate : public EyeRowDelegate {
    Q_OBJECT

public:
    using EyeRowDelegate::EyeRowDelegate;

protected:
    [[nodiscard]] Row row(const QModelIndex& index) const override;
    [[nodiscard]] int stateWidth() const override { return 74; }
    void eyeClicked(QAbstractItemModel& model, const QModelIndex& index,
        Qt::KeyboardModifiers modifiers) override;
};

} // namespace ui
