// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include <array>
#include <optional>

class QToolButton;

namespace ui {

/// A slim strip above the views with the four steps of mending a network's mask: look, mend,
/// compare, export. Each step is a button; the next one to do is highlighted. The strip only shows
/// states that showSteps() gives it (MendingSteps decides them).
class MendingStrip : public QFrame {
    Q_OBJECT

public:
    enum class Step { Look, Mend, Compare, Export };
    static constexpr std::size_t steps = 4;

    explicit MendingStrip(QWidget* parent = nullptr);

    /// Shows which steps are done.
    /// @param next the step that is highlighted; none: all are done
    void showSteps(const std::array<bool, steps>& done, std::optional<Step> next);
    [[nodiscard]] std::optional<Step> next() const { return m_next; }

Q_SIGNALS:
    void stepRequested(ui::MendingStrip::Step step);
    void closeRequested();

private:
    std::array<QToolButton*, steps> m_buttons{};
    std::optional<std::array<bool, steps>> m_done; ///< what is shown; none: nothing yet
    std::optional<Step> m_next;
};

} // namespace ui
