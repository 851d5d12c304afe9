// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace ui {

/// A bar of a growth's generations from left to right, drawn by the number of voxels in each: a
/// bulge means that the growth is leaking. A mark stands at the last generation that is shown;
/// dragging it shrinks the growth to an earlier generation and back again.
class GenerationBar : public QWidget {
    Q_OBJECT

public:
    explicit GenerationBar(QWidget* parent = nullptr);

    /// @param sizes voxels of each generation, from generation 1 on
    void setSizes(const std::vector<std::uint32_t>& sizes);
    [[nodiscard]] const std::vector<std::uint32_t>& sizes() const { return m_sizes; }
    /// The generation where the mark stands, 1 … number of generations.
    [[nodiscard]] int shown() const { return m_shown; }
    /// The range of generations in which it may have leaked; none if nothing is suspected.
    void setLeak(const std::optional<std::pair<int, int>>& generations);
    [[nodiscard]] const std::optional<std::pair<int, int>>& leak() const { return m_leak; }
    /// Sets whether the mark can be dragged.
    void setScrubbable(bool scrubbable);
    /// A text for a number of voxels.
    using SizeText = std::function<QString(std::int64_t voxels)>;
    /// Sets how sizes are written: "3.40 mL" while it is dragged, and "3 400 voxels, 3.4 mL" in
    /// tool tips. Without, both are the number.
    void setSizeTexts(SizeText size, SizeText counted);
    [[nodiscard]] bool scrubbing() const { return m_scrubbing; }
    /// Ends a drag that nothing follows, without scrubEnded(); the mark goes back to the last
    /// generation.
    void abandon();
    /// Where a drag stands, in words; empty without a drag.
    [[nodiscard]] QString scrubText() const;

    [[nodiscard]] QSize sizeHint() const override { return {240, 40}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 40}; }

Q_SIGNALS:
    void scrubBegan();
    void scrubbed(int generation);
    /// @param kept false if Escape was pressed: everything is to be as before
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
    SizeText m_size;
    SizeText m_counted;
    bool m_scrubbable = false;
    bool m_scrubbing = false;
};

} // namespace ui
