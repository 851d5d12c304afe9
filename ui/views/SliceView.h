// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "ui/geometry/SliceTurn.h"
#include "ui/geometry/ViewPlane.h"
#include "ui/views/ImageView.h"
#include "ui/views/Lens.h"
#include "ui/views/MprPlanes.h"

#include <optional>
#include <vector>

class QMenu;

namespace ui {

class SegmentLookButton;
struct CornerTexts;

/// A view of a plane of the patient: a standard plane through the crosshair, or the plane that a
/// derived class chooses.
class SliceView : public ImageView {
    Q_OBJECT

public:
    SliceView(Workspace& workspace, gpu::ViewId view, SliceOrientation orientation,
        QWidget* parent = nullptr);
    /// Constructs one of the three views whose planes are rotated by handles on the lines of the
    /// crosshair.
    SliceView(Workspace& workspace, gpu::ViewId view, SliceOrientation orientation,
        MprPlanes& planes, QWidget* parent = nullptr);

    /// Whether this view's plane is that of an early slice.
    [[nodiscard]] bool looksAt(const core::EarlySlice& early) const;
    [[nodiscard]] QString title() const override { return m_title; }
    [[nodiscard]] QColor barColour() const override { return m_colour; }
    /// The slice it shows, 0 … count − 1, and how many there are.
    [[nodiscard]] int sliceNumber() const;
    [[nodiscard]] int sliceCount() const;
    void goToSlice(int number);
    void resetView() override;

    /// The zoom and pan of a view. A view that still fits the window's size has none: the user has
    /// neither zoomed nor panned since resetView().
    struct Place {
        glm::dvec3 centreLps{0.0}; ///< its component along the normal does not count
        double mmPerPixel = 1.0;
    };
    [[nodiscard]] std::optional<Place> place() const;
    void setPlace(const Place& place);
    /// Sets the planes that are drawn as reference lines; without a call they are the patient's
    /// planes.
    void setReferencePlanes(const MprPlanes& planes);
    /// Takes the zoom and centre of another view, as far as its plane determines them: the
    /// component of the centre along the other view's normal stays.
    void lookWhereLooks(const SliceView& other);
    /// Pans so that a place, or its projection onto the plane, is in the middle of the view. A
    /// hidden view that fits the window's size keeps fitting it instead.
    void centreOn(const glm::dvec3& placeLps);
    /// How the slice is laid on the screen. A new study, and resetView(), lay it upright again.
    [[nodiscard]] const SliceTurn& turn() const { return m_turn; }
    void setTurn(const SliceTurn& turn);
    /// How this view draws segments if differently from all views; reset by a new study.
    [[nodiscard]] const Workspace::SegmentLook& segmentLook() const { return m_segmentLook; }
    void setSegmentLook(const Workspace::SegmentLook& look);
    /// Whether the next drag of the left button draws a box, whatever the tool.
    [[nodiscard]] bool awaitsBox() const { return m_awaitsBox; }
    /// Whether the lens lies over the slice: while its key (Z) is held and the pointer is here.
    [[nodiscard]] bool showsLens() const { return m_lens.isShown(); }
    [[nodiscard]] bool takes(gpu::ViewId view) const override;
    void takeFrame(const gpu::Frame& frame) override;
    void setAwaitsBox(bool awaits);

Q_SIGNALS:
    void placeChanged(); ///< the user has zoomed or panned in this view
    /// The user has drawn a box from whose values the window is to be set.
    void boxDrawn(const core::Measurement& box);
    void boxAbandoned(); ///< the user has cancelled drawing a box

protected:
    /// @param colour of the bar that names the view
    SliceView(Workspace& workspace, gpu::ViewId view, const SliceAxes& axes, const QString& title,
        const QColor& colour, QWidget* parent);

    /// Turns the plane; its middle and its scale stay.
    void setAxes(const SliceAxes& axes);
    [[nodiscard]] const SliceAxes& axes() const { return m_axes; }
    /// The axes of the slice as it lies on the screen.
    [[nodiscard]] SliceAxes axesOnScreen() const { return m_turn.of(m_axes); }
    /// A point through which the plane passes.
    [[nodiscard]] virtual glm::dvec3 throughLps() const;
    /// Moves the plane to pass through a point, without turning it.
    virtual void passThrough(const glm::dvec3& placeLps);
    virtual void paintCross(QPainter& painter, const ViewContext& shown);
    [[nodiscard]] const SliceStack& stack() const { return m_stack; }

    [[nodiscard]] gpu::Scene scene() const override;
    [[nodiscard]] gpu::SegmentDisplay segmentDisplay() const override;
    [[nodiscard]] Gesture gestureFor(
        Qt::MouseButton button, const PointerSample& sample, bool toolWorksHere) const override;
    void dragged(Gesture gesture, const QPointF& from, const QPointF& to) override;
    void dragEnded(Gesture gesture) override;
    void dragAbandoned() override;
    bool clicked(const QPointF& at) override;
    void menuAsked(const QPointF& at) override;
    void activateSegmentAt(const QPointF& at) override;
    void hovered(const PointerSample& sample) override;
    void wheelTurned(double steps, const QPointF& at, Qt::KeyboardModifiers modifiers) override;
    [[nodiscard]] bool ownsWheel(Qt::KeyboardModifiers modifiers) const override;
    void paintAnnotations(QPainter& painter, const ViewContext& shown) override;
    void paintOnTop(QPainter& painter) override;
    void requested(const gpu::FrameRequest& request) override;
    bool event(QEvent* event) override;
    [[nodiscard]] QImage earlyPictureOf(
        const gpu::Scene& scene, const QSize& pixels) const override;
    void earlySliceChanged() override { openVolume(); }
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    static constexpr double leastMmPerPixel = 1e-3;
    static constexpr double greatestMmPerPixel = 100.0;
    static constexpr int greatestSlabReach = 100; ///< number of slices on either side
    static constexpr int mostSlabSamples = 401; ///< of oblique slabs
    /// A handle on the line of a plane.
    struct Handle {
        SliceOrientation plane;
        QPointF at;
    };
    void openVolume();
    [[nodiscard]] bool turnsCrosshair() const;
    [[nodiscard]] bool isPatientPlane() const;
    /// Returns the direction on the screen of the line of another plane.
    [[nodiscard]] QPointF directionOf(SliceOrientation plane, const ViewContext& view) const;
    [[nodiscard]] std::vector<Handle> handles(const ViewContext& view) const;
    [[nodiscard]] std::optional<SliceOrientation> grabbedAt(const QPointF& at) const;
    void turnCrosshair(const QPointF& from, const QPointF& to, bool alone);
    void paintHandles(QPainter& painter, const ViewContext& shown) const;
    void zoomBy(double factor, const QPointF& at);
    /// The slab of the view options, with its samples on the slices of the stack and, if it is
    /// oblique, between them.
    [[nodiscard]] gpu::SceneSlab slab() const;
    [[nodiscard]] int slabReach() const; ///< number of slices on either side
    /// Switches the slab on, or changes its thickness by one slice on either side per step.
    void thickenSlab(double steps);
    /// Of the workspace, or of the early slice.
    [[nodiscard]] core::WindowLevel windowLevel() const;
    [[nodiscard]] double fittingMmPerPixel() const;
    [[nodiscard]] QString windowText() const;
    [[nodiscard]] CornerTexts cornerTexts(const gpu::SliceScene& slice) const;
    void holdLens(bool held);
    /// Moves the lens to the pointer.
    void moveLens();
    /// Adds the ways to lay the slice, its colours and interpolation, and how it draws segments, to
    /// the context menu.
    void listTurns(QMenu& menu);
    /// Draws the legend of the colours if grey values are shown in colours.
    void paintColours(QPainter& painter, const gpu::SliceScene& slice) const;
    /// Draws the lines in which axial, sagittal and coronal slices cut this one.
    void paintOtherSlices(QPainter& painter, const ViewContext& shown) const;

    SliceAxes m_axes; ///< of the upright slice
    MprPlanes* m_planes = nullptr; ///< null: this plane is not one of them
    const MprPlanes* m_referencePlanes = nullptr;
    std::optional<SliceOrientation> m_orientation; ///< which of the three planes it is
    std::optional<SliceOrientation> m_grabbed; ///< the plane whose line is being turned
    SliceTurn m_turn;
    Workspace::SegmentLook m_segmentLook;
    SegmentLookButton* m_lookButton;
    std::optional<QRectF> m_box; ///< the box that is being drawn
    bool m_awaitsBox = false;
    QString m_title;
    QColor m_colour;
    SliceStack m_stack;
    glm::dvec3 m_centreLps{0.0}; ///< its component along the normal does not count
    double m_mmPerPixel = 1.0;
    bool m_fitted = true; ///< fits the window until the user zooms or pans
    Lens m_lens;
    bool m_lensHeld = false; ///< the lens's key is down
    double m_wheelRest = 0.0;
    double m_slabRest = 0.0;
};

} // namespace ui
