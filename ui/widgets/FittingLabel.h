// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace ui {

/// One line of plain text, as much of it as fits; where something is cut, all of it is the tool
/// tip. Takes what room its layout leaves and asks for none.
class FittingLabel : public QLabel {
    Q_OBJECT

public:
    explicit FittingLabel(Qt::Alignment alignment, QWidget* parent = nullptr);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

} // namespace ui
