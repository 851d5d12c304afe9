// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace ui {

/// What this program is, which version, and what it is not.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    /// @param graphics the renderer's name and version
    explicit AboutDialog(const QString& graphics, QWidget* parent = nullptr);
};

} // namespace ui
