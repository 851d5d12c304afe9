// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <cstdint>
#include <functional>
#include <vector>

namespace ui {

/// The tolerances of a field from left to right, drawn as how large the segment is at each: both
/// axes are compressed, so that small tolerances and small segments have room. Jumps stand out. The
/// mark is dragged, or moved by the arrow keys, back and forth; letting go, or Return, keeps where
/// it stands, Escape takes it back.
class ToleranceBar : public QWidget {
    Q_OBJECT

public:
    explicit ToleranceBar(QWidget* parent = nullptr);

    /// @param members place t: how many voxels the segment has at tolerance t
    /// @param jumps tolerances, ascending
    void setCurve(std::vector<std::int64_t> members, std::vector<int> jumps);
    [[nodiscard]] const std::vector<std::int64_t>& members() const { return m_members; }
    [[nodiscard]] const std::vector<int>& jumps() const { return m_jumps; }
    /// How a tolerance is told: "±37 HU".
    void setText(std::function<QString(int tolerance)> text) { m_text = std::move(text); }
    void setVoxelMm3(double voxelMm3) { m_voxelMm3 = voxelMm3; }
    /// Where the mark stands; −1: it was never moved.
    [[nodiscard]] int tolerance() const { return m_tolerance; }
    void setTolerance(int tolerance);
    [[nodiscard]] bool moving() const { return m_moving; }
    /// Where a tolerance lies, in pixels from the left.
    [[nodiscard]] double xOf(int tolerance) const;
    /// "±37 HU · 12.4 mL".
    [[nodiscard]] QString textFor(int tolerance) const;

    [[nodiscard]] QSize sizeHint() const override { return {240, 52}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 52}; }

Q_SIGNALS:
    void moved(int tolerance);
    /// @param kept false: all is to be as before
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
    double m_voxelMm3 = 0.0;
    int m_tolerance = -1;
    int m_before = -1; ///< while it moves: where the mark stood
    bool m_moving = false;
};

} // namespace ui
