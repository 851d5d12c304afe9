// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace ui {

/// The generations of a growth from left to right, drawn as voxels that each has: a bulge is a leak
/// on its way. The mark stands at the last one that is shown; dragging it goes back through the
/// growth and forth again.
class GenerationBar : public QWidget {
    Q_OBJECT

public:
    explicit GenerationBar(QWidget* parent = nullptr);

    /// @param sizes of the generations from 1 on
    void setSizes(const std::vector<std::uint32_t>& sizes);
    [[nodiscard]] const std::vector<std::uint32_t>& sizes() const { return m_sizes; }
    /// Where the mark stands: 1 … as many as there are.
    [[nodiscard]] int shown() const { return m_shown; }
    /// From which generation to which it may have leaked; none: nothing is suspected.
    void setLeak(const std::optional<std::pair<int, int>>& generations);
    [[nodiscard]] const std::optional<std::pair<int, int>>& leak() const { return m_leak; }
    /// Whether it can be dragged.
    void setScrubbable(bool scrubbable);
    /// For tool tips and the millilitres there.
    void setVoxelMm3(double voxelMm3) { m_voxelMm3 = voxelMm3; }
    [[nodiscard]] bool scrubbing() const { return m_scrubbing; }
    /// Where a drag stands, in words; empty: there is none.
    [[nodiscard]] QString scrubText() const;

    [[nodiscard]] QSize sizeHint() const override { return {240, 40}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 40}; }

Q_SIGNALS:
    void scrubBegan();
    void scrubbed(int generation);
    /// @param kept false: Escape was pressed, all is to be as before
    void scrubEnded(bool kept);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] int generationAt(double x) const;
    [[nodiscard]] double xOf(int generation) const;
    [[nodiscard]] QString textFor(int generation) const;
    void paintLeak(QPainter& painter) const;
    void scrubTo(int generation);
    void endScrub(bool kept);

    std::vector<std::uint32_t> m_sizes;
    std::optional<std::pair<int, int>> m_leak;
    int m_shown = 0;
    double m_voxelMm3 = 0.0;
    bool m_scrubbable = false;
    bool m_scrubbing = false;
};

} // namespace ui
