// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/Tolerance.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace core {
class EditSession;
}

namespace ui {

class ToleranceBar;
class Workspace;

/// The tolerance of the active segment, a part of the growth panel: once its field is traced, every
/// view shows the segment at whatever tolerance the mark is dragged to, and letting go makes it
/// real, as one step. The field is traced again by itself after whatever else was done.
class ToleranceSection : public QWidget {
    Q_OBJECT

public:
    explicit ToleranceSection(Workspace& workspace, QWidget* parent = nullptr);

    /// Whether the field is there and told about.
    [[nodiscard]] bool traced() const { return m_traced && !m_asking && !m_stale; }

private:
    void build();
    void turn(bool on);
    void reset();
    void follow();
    void ask();
    /// @param curve none: there is more to be worked out
    void take(const core::ToleranceRule& rule,
        const core::Result<std::optional<core::ToleranceCurve>>& curve);
    void preview(int tolerance);
    void settle(bool kept);
    void makeReal(int tolerance);
    void showText();
    void refuse(const core::Error& error);
    [[nodiscard]] core::Result<core::ToleranceRule> rule() const;
    [[nodiscard]] bool othersGrowAlong() const;

    Workspace& m_workspace;
    QPushButton* m_trace = nullptr;
    ToleranceBar* m_bar = nullptr;
    QLabel* m_text = nullptr;
    QTimer m_again; ///< steps come in bursts, one field is enough for them
    core::EditSession* m_asked = nullptr; ///< who is to answer; compared, never called
    bool m_on = false;
    bool m_asking = false;
    bool m_stale = false; ///< something was done since it was traced
    std::optional<core::ToleranceRule> m_traced;
    int m_centre = 0; ///< code
    QString m_whyNot;
};

} // namespace ui
