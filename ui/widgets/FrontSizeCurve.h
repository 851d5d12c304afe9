// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <cstdint>
#include <vector>

namespace ui {

/// Voxels that a growth added, generation by generation: a bulge is a leak on its way.
class FrontSizeCurve : public QWidget {
    Q_OBJECT

public:
    explicit FrontSizeCurve(QWidget* parent = nullptr);

    void setSizes(const std::vector<std::uint32_t>& sizes);

    [[nodiscard]] QSize sizeHint() const override { return {240, 40}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<std::uint32_t> m_sizes;
};

} // namespace ui
