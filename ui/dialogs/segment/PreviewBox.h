// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCheckBox>

namespace ui {

/// The box of a dialog or panel that switches its preview on and off. It is checked at first; each
/// of them remembers its own.
class PreviewBox : public QCheckBox {
    Q_OBJECT

public:
    /// @param name of the dialog or panel: "reshape" gives the object name "reshapePreview"
    /// @param isOn until the user has chosen
    explicit PreviewBox(const QString& name, QWidget* parent = nullptr, bool isOn = true);
};

} // namespace ui
