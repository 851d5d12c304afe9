// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/PanelSection.h"

#include <QScrollArea>

#include <vector>

class QSettings;
class QVBoxLayout;

namespace ui {

class Panel;

/// The right column of the window with its panels, and the panels that were moved to windows of
/// their own. Lists share the height that the other panels leave. If the window is too low for all
/// of them, the column scrolls.
class PanelColumn : public QScrollArea {
    Q_OBJECT

public:
    /// Includes the scroll bar, so that panels keep their width when it appears.
    static constexpr int leastWidth = PanelSection::leastWidth + 10;

    explicit PanelColumn(QWidget* parent = nullptr);

    /// Takes ownership of a panel and appends it at the bottom.
    PanelSection& add(ui::Panel* panel);

    /// Shows or hides one panel, in the column or in its own window.
    void setWanted(PanelSection& section, bool wanted);
    [[nodiscard]] bool isWanted(const PanelSection& section) const;
    void setFloating(PanelSection& section, bool floating);
    /// Shows a panel, unfolds it and scrolls to it.
    void bringUp(const ui::Panel& panel);
    /// Shows or hides all wanted panels together. The column hides when it holds none.
    void showAll(bool shown);
    /// Enables or disables the panels. Before a study is open they take their places but cannot be
    /// used.
    void setUsable(bool usable);
    /// Restores the arrangement of the first start.
    void reset();

    void save(QSettings& settings) const;
    void restore(const QSettings& settings);

    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    /// Places or visibility of panels have changed.
    void changed();

private:
    struct Place {
        PanelSection* section;
        bool wanted = true;
    };

    void putBack(PanelSection& section);
    void update();

    QVBoxLayout* m_layout;
    std::vector<Place> m_places; ///< in the column's order
    bool m_shown = false;
};

} // namespace ui
