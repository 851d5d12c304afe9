// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/lists/EyeRowDelegate.h"

namespace ui {

/// A row of the list of sculpt layers: eye, name, what it does now. A click on the eye mutes or
/// unmutes; with Alt it has the layer count alone (solo).
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
