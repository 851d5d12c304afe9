// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/overlays/Readout.h"

#include <QFrame>
#include <QTimer>

class QLabel;

namespace ui {

/// Below the views: where, what value and which segment · what the tool expects next, or what has
/// just happened · pen and timing.
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
    double m_pressure = -1.0; ///< none so far
    double m_frameMilliseconds = 0.0;
};

} // namespace ui
