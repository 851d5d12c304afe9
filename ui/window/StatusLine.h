// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/overlays/Readout.h"

#include <QFrame>
#include <QTimer>

class QLabel;

namespace ui {

/// The line below the views: position, value and segment at the pointer · what the tool expects
/// next, or what has just happened · pen pressure and frame time.
class StatusLine : public QFrame {
    Q_OBJECT

public:
    explicit StatusLine(Workspace& workspace, QWidget* parent = nullptr);

    void showFrameTime(double milliseconds);
    [[nodiscard]] QString readout() const;

private:
    void showHint();
    void showMachine();

    Workspace& m_workspace;
    Readout m_readout;
    QLabel* m_where;
    QLabel* m_hint;
    QLabel* m_machine;
    QTimer m_saidTimer;
    double m_pressure = -1.0; ///< −1: none so far
    double m_frameMilliseconds = 0.0;
};

} // namespace ui
