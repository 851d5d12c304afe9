// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPoint>
#include <QWidget>

#include <optional>

class QToolButton;

namespace ui {

class Panel;

/// A panel with its header: title, summary and the panel's actions. A click on the header folds the
/// panel, dragging the header moves it to a window of its own; its button there, or closing that
/// window, puts it back.
class PanelSection : public QWidget {
    Q_OBJECT

public:
    static constexpr int leastWidth = 266;

    explicit PanelSection(Panel& panel, QWidget* parent = nullptr);

    [[nodiscard]] Panel& panel() const { return m_panel; }
    /// The class name of the panel, which identifies it in the settings.
    [[nodiscard]] QString id() const;

    void setFolded(bool folded);
    [[nodiscard]] bool isFolded() const { return m_folded; }
    /// Called by the column, which moves the section: makes it a window of its own over @p owner,
    /// or part of a layout.
    void becomeWindow(QWidget* owner);
    void becomePart(QWidget* parent);
    [[nodiscard]] bool isFloating() const { return isWindow(); }

    // The column uses a single height: what the panel needs at the section's width, or for a list
    // its least useful height. (A height that depends on the width would keep shrinking.)
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
    [[nodiscard]] bool hasHeightForWidth() const override { return false; }

Q_SIGNALS:
    void folded(bool folded);
    void floatRequested(bool floating);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void buildHeader();
    void showPlace();

    Panel& m_panel;
    QWidget* m_header;
    QToolButton* m_fold;
    QToolButton* m_place;
    bool m_folded = false;
    std::optional<QPoint> m_pressed; ///< where the mouse was pressed in the header
};

} // namespace ui
