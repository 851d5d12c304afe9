// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/CursorTool.h"

namespace ui {

class Workspace;

/// Adds to the active segment the connected voxels whose values differ little from that of the
/// clicked voxel. With Ctrl or the pen's eraser end it removes the connected part of the segment
/// instead. It works within the slice or in 3D. Each click is one step. If there is no segment, the
/// first click adds one, as a step of its own.
class FloodFillTool : public CursorTool {
    Q_OBJECT

public:
    struct Settings {
        bool in3D = false;
        bool corners = false; ///< voxels also count as connected at an edge or a corner
        double tolerance = 50.0; ///< greatest difference of values, modality units
        bool operator==(const Settings&) const = default;
    };

    explicit FloodFillTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override { return action(m_erases); }
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    /// Works in slices, also in oblique ones.
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    /// Aborts a fill that is still being computed.
    void cancel() override;
    /// Does nothing: a fill goes on when another tool is chosen.
    void putAway() override { }
    void hover(const PointerSample& sample, const ViewContext& view) override;
    /// Changes the tolerance.
    void changeRadius(int steps) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    [[nodiscard]] const Settings& settings() const { return m_settings; }
    void setSettings(const Settings& settings);

Q_SIGNALS:
    void settingsChanged();

private:
    [[nodiscard]] QString action(bool erases) const;
    [[nodiscard]] double step() const;

    Workspace& m_workspace;
    Settings m_settings;
    bool m_erases = false;
};

} // namespace ui
