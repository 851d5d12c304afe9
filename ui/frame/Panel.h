// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace ui {

/// A panel: a section in the right column of the window. The window shows title and summary in the
/// section's header, and the panel's actions() (QWidget::actions) as small buttons there.
class Panel : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    [[nodiscard]] virtual QString title() const = 0;
    /// A short text at the right of the header, for example "41 steps · 312 KB".
    [[nodiscard]] virtual QString summary() const { return {}; }
    /// Whether it takes the remaining height (lists) instead of its size hint.
    [[nodiscard]] virtual bool stretches() const { return false; }
    /// Whether it starts folded, until the user unfolds it.
    [[nodiscard]] virtual bool foldedAtFirst() const { return false; }
    /// Whether it has anything to show; a panel without takes no room.
    [[nodiscard]] virtual bool hasSomething() const { return true; }

Q_SIGNALS:
    void summaryChanged(const QString& summary);
    /// The user did something in the header whose result is in the panel's body.
    void unfoldRequested();
    void hasSomethingChanged();
};

} // namespace ui
