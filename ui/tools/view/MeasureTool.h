// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "ui/measure/AxesOfSegment.h"
#include "ui/tools/common/CursorTool.h"

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Measures and annotates: distances, angles, regions with the values in them, single values,
/// arrows and texts, in any slice. Kinds that need no plane also work on what the 3D view shows.
/// There, points on a piece are taken at their true place, so a length is true however the piece
/// was moved or scaled. Each result is one AddMeasurement or Annotate and is drawn in every view
/// (overlays/MeasurementLines.h).
///
/// Most kinds are one drag. An angle is a drag along its first side, then a click or drag to the
/// end of the second. A probe and a text are a click; so is the suggestion of a segment's axes,
/// which gives two distances (measure/AxesOfSegment.h).
///
/// Points of a measurement in the slice can be moved: a press near one takes hold of it
/// (core/measure/MeasureHandles.h), and the drag is one MoveMeasurement.
class MeasureTool : public CursorTool {
    Q_OBJECT

public:
    using Kind = core::Measurement::Kind;

    explicit MeasureTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    /// The kind, the text of an arrow or note, and the list from which measurements can be removed.
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    [[nodiscard]] Kind kind() const { return m_kind; }
    void setKind(Kind kind);
    /// Whether a click measures the axes of the segment there.
    [[nodiscard]] bool suggestsAxes() const { return m_suggestsAxes; }
    void suggestAxes();
    /// The text of the next arrow or note.
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
    /// A point of a measurement in a slice that the pointer holds.
    struct Held {
        core::Measurement measured; ///< the measurement before the drag
        std::size_t point = 0;
        glm::dvec3 pressedLps{0.0}; ///< place of the press
        core::Measurement moved; ///< the measurement as dragged so far
    };
    [[nodiscard]] std::optional<Held> heldAt(const QPointF& at, const ViewContext& view) const;
    void dragHeld(const QPointF& to);
    void letGo();
    void moveLast(const PointerSample& sample);
    [[nodiscard]] bool isMeant() const;
    /// The measurement that the drawn points give.
    [[nodiscard]] core::Measurement drawn() const;
    void finish();
    void measureWhatIsSeen(const core::Measurement& drawn, const ViewContext& view);
    void keep(const core::Measurement& measured);
    [[nodiscard]] QString howToDraw() const;

    Workspace& m_workspace;
    Kind m_kind = Kind::Distance;
    bool m_suggestsAxes = false; ///< m_kind is Distance then
    AxesOfSegment m_axes;
    QString m_text;
    /// The view of the first press, until the measurement is finished.
    std::optional<ViewContext> m_view;
    bool m_pressed = false;
    std::optional<Held> m_held;
    std::vector<glm::dvec3> m_points; ///< the drawn points, on the plane of the view
};

} // namespace ui
