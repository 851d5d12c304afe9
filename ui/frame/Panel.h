// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace ui {

/// A section of the window's right side. The window shows title and summary in the section's
/// header, and the panel's actions() (QWidget::actions) as small buttons there.
class Panel : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    [[nodiscard]] virtual QString title() const = 0;
    /// Short, secondary, at the header's right: "41 steps · 312 KB".
    [[nodiscard]] virtual QString summary() const { return {}; }
    /// Takes what height is left (lists), instead of its size hint.
    [[nodiscard]] virtual bool stretches() const { return false; }
    /// Until the user unfolds it.
    [[nodiscard]] virtual bool foldedAtFirst() const { return false; }
    /// A panel that has nothing takes no place.
    [[nodiscard]] virtual bool hasSomething() const { return true; }

Q_SIGNALS:
    void summaryChanged(const QString& summary);
    /// What was done in the header is to be seen.
    void unfoldAsked();
    void hasSomethingChanged();
};

} // namespace ui
