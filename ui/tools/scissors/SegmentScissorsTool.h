// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "ui/tasks/trials/SplitTrial.h"
#include "ui/tools/common/CursorTool.h"
#include "ui/tools/common/CurveSketch.h"
#include "ui/tools/common/PenPressure.h"

#include <vector>

class QPainterPath;

namespace ui {

class Workspace;

/// Erases or fills the active segment inside or outside of a curve drawn on the 3D view, along the
/// view direction. With Ctrl or the pen's eraser end it fills instead of erasing and the reverse.
/// Inside the curve it may stop at a depth behind the first surface, which may follow the pressure
/// of the pen. Or it makes a new segment of what lies on one side of a curve or of a line across
/// the picture; then Ctrl means the other side, and the volumes of both parts are shown while it is
/// drawn. Which voxels may change is set as for painting. Each curve is one step.
class SegmentScissorsTool : public CursorTool {
    Q_OBJECT

public:
    enum class Does {
        EraseInside,
        EraseOutside,
        FillInside,
        FillOutside,
        SplitInside,
        SplitOutside,
        SplitAlong, ///< a line; its smaller side is split off
    };
    using Shape = CurveSketch::Shape;
    struct Settings {
        Does does = Does::EraseInside;
        Shape shape = Shape::Freehand;
        double depthMm = 0.0; ///< 0: through everything
        bool depthByPressure = false; ///< the pen's pressure sets the depth, where there is one
        bool allShown = false; ///< erases all segments that are shown and not locked
        bool operator==(const Settings&) const = default;
    };
    static constexpr double maximumDepthMm = 300.0;
    [[nodiscard]] static bool erases(Does does);
    [[nodiscard]] static bool isOutside(Does does);
    [[nodiscard]] static bool splits(Does does);
    /// Whether it may stop at a depth.
    [[nodiscard]] static bool hasDepth(Does does);

    explicit SegmentScissorsTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString longName() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void changeDepth(int steps) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    /// The volumes of both parts that the curve drawn so far would make ("Liver: 1 043 mL · Liver
    /// 1: 482.1 mL"), as far as they are counted; empty while nothing is being split, or if limits
    /// of editing would change them.
    [[nodiscard]] QString partsLine() const;

    [[nodiscard]] const Settings& settings() const { return m_settings; }
    /// Changes the settings. A curve that is being drawn is dropped.
    void setSettings(const Settings& settings);

Q_SIGNALS:
    void settingsChanged();

private:
    /// The labels of the segments that it would change, the active one first; empty: there is none
    /// that it may change.
    [[nodiscard]] std::vector<int> targets() const;
    /// The setting, or its opposite while Ctrl or the eraser end is used.
    [[nodiscard]] Does doesNow() const;
    /// How deep the curve goes that is being drawn, or what is set; 0: through everything.
    [[nodiscard]] double depthMm() const;
    void cut(const ViewContext& view, const std::vector<glm::dvec2>& curve);
    void split(const ViewContext& view, const std::vector<glm::dvec2>& curve);
    /// The edit that splits the active segment, which exists, as a document knows it.
    [[nodiscard]] core::SplitByCurve splitOf(const ViewContext& view,
        const std::vector<glm::dvec2>& curve, const core::Document& document) const;
    /// Starts counting both parts that the curve drawn so far would make.
    void lookAtParts();
    void paintCut(QPainter& painter, const ViewContext& view) const;
    /// The side that would change, or become the new segment; empty while it is not known.
    [[nodiscard]] QPainterPath changedSide(const ViewContext& view) const;

    Workspace& m_workspace;
    Settings m_settings;
    CurveSketch m_sketch;
    StrokePressure m_pressure; ///< of the curve that is being drawn
    bool m_inverts = false;
    SplitTrial m_trial; ///< of the curve that is being drawn
};

} // namespace ui
