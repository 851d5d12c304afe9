// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/views/ImageView.h"
#include "ui/views/SlicePlane.h"

namespace ui {

/// A standard plane of the patient through the crosshair.
class SliceView : public ImageView {
    Q_OBJECT

public:
    SliceView(Workspace& workspace, gpu::ViewId view, SliceOrientation orientation,
        QWidget* parent = nullptr);

    [[nodiscard]] SliceOrientation orientation() const { return m_orientation; }
    /// Whether this view would show an early slice.
    [[nodiscard]] bool looksAt(const core::EarlySlice& early) const;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QColor barColour() const override;
    /// The slice the crosshair is in, 0 … count − 1, and how many there are.
    [[nodiscard]] int sliceNumber() const;
    [[nodiscard]] int sliceCount() const;
    void goToSlice(int number);
    void resetView() override;

    /// Zoom and pan. A view that follows the window's size has no such place: the user has neither
    /// zoomed nor panned since resetView().
    struct Place {
        glm::dvec3 centreLps{0.0}; ///< its part along the normal does not count
        double mmPerPixel = 1.0;
    };
    [[nodiscard]] std::optional<Place> place() const;
    void setPlace(const Place& place);

protected:
    [[nodiscard]] gpu::Scene scene() const override;
    [[nodiscard]] Gesture gestureFor(Qt::MouseButton button, bool toolWorksHere) const override;
    void dragged(Gesture gesture, const QPointF& from, const QPointF& to) override;
    void clicked(const QPointF& at) override;
    void hovered(const PointerSample& sample) override;
    void wheelTurned(double steps, const QPointF& at, Qt::KeyboardModifiers modifiers) override;
    void paintAnnotations(QPainter& painter, const ViewContext& shown) override;
    [[nodiscard]] QImage earlyPictureOf(
        const gpu::Scene& scene, const QSize& pixels) const override;
    void earlySliceChanged() override { openVolume(); }
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void openVolume();
    void zoomBy(double factor, const QPointF& at);
    /// The plane, the grey scale: of the window, or of the early slice.
    [[nodiscard]] glm::dvec3 crosshairLps() const;
    [[nodiscard]] core::WindowLevel windowLevel() const;
    [[nodiscard]] double fittingMmPerPixel() const;
    [[nodiscard]] QString windowText() const;

    SliceOrientation m_orientation;
    SliceAxes m_axes;
    SliceStack m_stack;
    glm::dvec3 m_centreLps{0.0}; ///< its part along the normal does not count
    double m_mmPerPixel = 1.0;
    bool m_fitted = true; ///< follows the window until the user zooms or pans
    double m_wheelRest = 0.0;
};

} // namespace ui
