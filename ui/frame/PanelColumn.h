// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/PanelSection.h"

#include <QScrollArea>

#include <vector>

class QSettings;
class QVBoxLayout;

namespace ui {

class Panel;

/// The window's right column, and the panels that were taken out of it. Lists share the height that
/// the other panels leave; where a window is too low for all, the column scrolls.
class PanelColumn : public QScrollArea {
    Q_OBJECT

public:
    /// With room for the scroll bar, so that panels keep theirs when it shows.
    static constexpr int leastWidth = PanelSection::leastWidth + 10;

    explicit PanelColumn(QWidget* parent = nullptr);

    /// Takes it over; below those before it.
    PanelSection& add(ui::Panel* panel);

    /// One panel at its place: in the column, or in a window of its own.
    void setWanted(PanelSection& section, bool wanted);
    [[nodiscard]] bool isWanted(const PanelSection& section) const;
    void setFloating(PanelSection& section, bool floating);
    /// Wanted, unfolded and in sight.
    void bringUp(const ui::Panel& panel);
    /// All wanted ones at once; the column hides when it holds none.
    void showAll(bool shown);
    /// Panels that are shown before there is a study to work on take their places and wait.
    void setUsable(bool usable);
    /// As at the first start.
    void reset();

    void save(QSettings& settings) const;
    void restore(const QSettings& settings);

    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    /// What is where, or shown at all.
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
