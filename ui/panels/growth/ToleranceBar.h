// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <cstdint>
#include <functional>
#include <vector>

namespace ui {

/// A bar of tolerances from left to right, drawn by how large the segment is at each. Both axes are
/// compressed so that small tolerances and small segments have room; jumps in the size are marked.
/// The mark is moved by dragging or by the arrow keys. Releasing it, or Return, keeps the new
/// tolerance; Escape takes it back.
class ToleranceBar : public QWidget {
    Q_OBJECT

public:
    explicit ToleranceBar(QWidget* parent = nullptr);

    /// @param members element t: the number of voxels of the segment at tolerance t
    /// @param jumps tolerances at which the size jumps, ascending
    void setCurve(std::vector<std::int64_t> members, std::vector<int> jumps);
    [[nodiscard]] const std::vector<std::int64_t>& members() const { return m_members; }
    [[nodiscard]] const std::vector<int>& jumps() const { return m_jumps; }
    /// Sets how a tolerance is written, for example "±37 HU".
    void setText(std::function<QString(int tolerance)> text) { m_text = std::move(text); }
    /// Sets how a number of voxels is written, for example "12.4 mL".
    void setSizeText(std::function<QString(std::int64_t voxels)> size) { m_size = std::move(size); }
    /// The tolerance where the mark stands; −1 if it was never moved.
    [[nodiscard]] int tolerance() const { return m_tolerance; }
    void setTolerance(int tolerance);
    [[nodiscard]] bool moving() const { return m_moving; }
    /// Ends a move that is under way, as Escape does.
    void cancel() { settle(false); }
    /// The x position of a tolerance, in pixels from the left.
    [[nodiscard]] double xOf(int tolerance) const;
    /// "±37 HU · 12.4 mL".
    [[nodiscard]] QString textFor(int tolerance) const;

    [[nodiscard]] QSize sizeHint() const override { return {240, 52}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 52}; }

Q_SIGNALS:
    void moved(int tolerance);
    /// @param kept false if everything is to be as before
    void settled(bool kept);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] int greatest() const { return int(m_members.size()) - 1; }
    [[nodiscard]] int toleranceAt(double x) const;
    [[nodiscard]] double heightOf(std::int64_t voxels) const;
    void begin();
    void moveTo(int tolerance);
    void settle(bool kept);

    std::vector<std::int64_t> m_members;
    std::vector<int> m_jumps;
    std::function<QString(int tolerance)> m_text;
    std::function<QString(std::int64_t voxels)> m_size;
    int m_tolerance = -1;
    int m_before = -1; ///< where the mark stood before it is moved
    bool m_moving = false;
};

} // namespace ui
