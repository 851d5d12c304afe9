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

/// The part of the growth panel for the tolerance of the active segment. Once its tolerance field
/// is traced, every view shows the segment at the tolerance to which the user drags the mark;
/// releasing the mark applies it as one step. After any other edit the field is traced again.
class ToleranceSection : public QWidget {
    Q_OBJECT

public:
    explicit ToleranceSection(Workspace& workspace, QWidget* parent = nullptr);

    /// Whether the field is complete and up to date.
    [[nodiscard]] bool traced() const { return m_traced && !m_asking && !m_stale; }
    /// Takes the button that switches it on out of the section, for another place. What remains is
    /// hidden while it has nothing to show.
    [[nodiscard]] QPushButton* takeButton();

Q_SIGNALS:
    /// The bar has appeared or disappeared.
    void barShown(bool shown);

private:
    void build();
    void turn(bool on);
    void reset();
    void follow();
    void ask();
    /// @param curve none if the computation goes on
    void take(const core::ToleranceRule& rule,
        const core::Result<std::optional<core::ToleranceCurve>>& curve);
    [[nodiscard]] bool isUpToDate() const;
    void preview(int tolerance);
    void settle(bool kept);
    void makeReal(int tolerance);
    void showText();
    void refuse(const core::Error& error);
    [[nodiscard]] core::Result<core::ToleranceRule> rule() const;

    Workspace& m_workspace;
    QWidget* m_head = nullptr; ///< null: the button was taken
    QPushButton* m_trace = nullptr;
    ToleranceBar* m_bar = nullptr;
    bool m_hasBar = false; ///< the bar is shown
    QLabel* m_text = nullptr;
    QTimer m_again; ///< traces once after several steps in quick succession
    /// The session that is to answer; only compared, never called.
    core::EditSession* m_asked = nullptr;
    bool m_on = false;
    bool m_asking = false;
    bool m_stale = false; ///< an edit was made since it was traced
    std::optional<core::ToleranceRule> m_traced;
    int m_centre = 0; ///< code
    QString m_whyNot;
};

} // namespace ui
