// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace ui {

/// Says what this program is, which version it is, and that it is not a medical device.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    /// @param graphics the renderer's name and version
    explicit AboutDialog(const QString& graphics, QWidget* parent = nullptr);
};

} // namespace ui
