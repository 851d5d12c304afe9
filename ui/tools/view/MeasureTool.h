// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "ui/measure/AxesOfSegment.h"
#include "ui/tools/common/CursorTool.h"

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Measures and notes: a distance, an angle, a region with the values in it, a value, an arrow or a
/// text, on any slice, and what needs no plane also on what the 3D view shows. Points on a piece
/// are taken at their true place, so that a length is true however the piece was moved or zoomed.
/// Each is one AddMeasurement or Annotate, drawn in every view (overlays/MeasurementLines.h).
///
/// All are one drag; an angle is a drag along its first side, then a click or drag at the end of
/// the other one; a probe or a text is a click, and so is the suggestion of a segment's axes, which
/// are two distances (measure/AxesOfSegment.h).
///
/// What is drawn by a drag can also be moved by one: a press near a point of a measurement that the
/// slice shows takes hold of it (core/measure/MeasureHandles.h), and the drag is one
/// MoveMeasurement.
class MeasureTool : public CursorTool {
    Q_OBJECT

public:
    using Kind = core::Measurement::Kind;

    explicit MeasureTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    /// The shape, what an arrow or text says, and the list from which measurements can be removed.
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    [[nodiscard]] Kind kind() const { return m_kind; }
    void setKind(Kind kind);
    /// Whether a click suggests the axes of the segment there, whatever the kind.
    [[nodiscard]] bool suggestsAxes() const { return m_suggestsAxes; }
    void suggestAxes();
    /// What the next arrow or text says.
    [[nodiscard]] const QString& text() const { return m_text; }
    void setText(const QString& text);

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    [[nodiscard]] bool canTakeStepBack() const override;
    void takeStepBack() override { cancel(); }

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

Q_SIGNALS:
    void kindChanged();
    void textChanged();

private:
    [[nodiscard]] bool isClicked() const
    {
        return m_suggestsAxes || m_kind == Kind::Probe || m_kind == Kind::Text;
    }
    [[nodiscard]] bool isNote() const { return m_kind == Kind::Arrow || m_kind == Kind::Text; }
    /// Whether the view still shows what it showed at the first press.
    [[nodiscard]] bool isSameView(const ViewContext& view) const;
    /// A point of a measurement under the pointer, in a slice.
    struct Held {
        core::Measurement measured; ///< as it was
        std::size_t point = 0;
        glm::dvec3 pressedLps{0.0}; ///< where the pointer was
        core::Measurement moved; ///< as it is dragged
    };
    [[nodiscard]] std::optional<Held> heldAt(const QPointF& at, const ViewContext& view) const;
    void dragHeld(const QPointF& to);
    void letGo();
    void moveLast(const PointerSample& sample);
    [[nodiscard]] bool isMeant() const;
    /// What the points that were drawn mean.
    [[nodiscard]] core::Measurement drawn() const;
    void finish();
    void measureWhatIsSeen(const core::Measurement& drawn, const ViewContext& view);
    void keep(const core::Measurement& measured);
    [[nodiscard]] QString howToDraw() const;

    Workspace& m_workspace;
    Kind m_kind = Kind::Distance;
    bool m_suggestsAxes = false; ///< the kind is then a distance
    AxesOfSegment m_axes;
    QString m_text;
    std::optional<ViewContext> m_view; ///< that of the first press, until it is finished
    bool m_pressed = false;
    std::optional<Held> m_held;
    std::vector<glm::dvec3> m_points; ///< as they were drawn, on the plane of the view
};

} // namespace ui
