// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include <array>
#include <optional>

class QToolButton;

namespace ui {

/// A slim strip over the views with the steps in which a network's mask is mended: look, mend,
/// compare, export. Each is a button; the next one is emphasised. It knows nothing but that.
class MendingStrip : public QFrame {
    Q_OBJECT

public:
    enum class Step { Look, Mend, Compare, Export };
    static constexpr std::size_t steps = 4;

    explicit MendingStrip(QWidget* parent = nullptr);

    /// @param next the step that is emphasised; none: all are done
    void showSteps(const std::array<bool, steps>& done, std::optional<Step> next);
    [[nodiscard]] std::optional<Step> next() const { return m_next; }

Q_SIGNALS:
    void stepRequested(ui::MendingStrip::Step step);
    void closeRequested();

private:
    std::array<QToolButton*, steps> m_buttons{};
    std::optional<std::array<bool, steps>> m_done; ///< as shown; none: nothing was shown yet
    std::optional<Step> m_next;
};

} // namespace ui
