// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/CursorTool.h"

namespace ui {

class Workspace;

/// Gives the active segment what hangs together with the voxel that is clicked and has about its
/// value; with Ctrl or the pen's eraser end it takes away what hangs together of the segment there.
/// In the slice alone or in all directions. Each click is one step. The first one of a session
/// makes a segment, as a step of its own.
class FloodFillTool : public CursorTool {
    Q_OBJECT

public:
    struct Settings {
        bool in3D = false;
        bool corners = false; ///< voxels also hang together at an edge or a corner
        double tolerance = 50.0; ///< modality units
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
    /// Axial, coronal and sagittal slices: an oblique one has no voxels of its own.
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    /// Abandons a fill that takes long.
    void cancel() override;
    /// A fill goes on when another tool is chosen.
    void putAway() override { }
    void hover(const PointerSample& sample, const ViewContext& view) override;
    /// The tolerance.
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
