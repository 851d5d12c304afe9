// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/Camera.h"
#include "ui/geometry/Stereo.h"
#include "ui/overlays/OrientationCube.h"
#include "ui/views/ImageView.h"
#include "ui/views/SeenReadout.h"

#include <functional>
#include <optional>

namespace ui {

class ContextSwitch;

/// The 3D view: the sculpted volume and its segments, seen by an orthographic camera.
class VolumeView : public ImageView {
    Q_OBJECT

public:
    VolumeView(Workspace& workspace, gpu::ViewId view, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QColor barColour() const override;
    [[nodiscard]] const Camera& camera() const { return m_camera; }
    void setCamera(const Camera& camera);
    /// Whether it fits the whole volume to the window's size; true until the user zooms or pans.
    [[nodiscard]] bool fitted() const { return m_fitted; }
    /// Shows the whole volume from the direction of @p camera.
    void fitCamera(const Camera& camera);
    /// Looks at the patient from a side, e.g. (0, −1, 0) from the front.
    void lookFrom(const glm::dvec3& sideLps);
    /// Moves a point of the patient to the middle, seen from the direction @p fromLps; if that is
    /// 0, from the present one.
    void flyTo(const glm::dvec3& placeLps, const glm::dvec3& fromLps);
    void resetView() override;

    [[nodiscard]] const Stereo& stereo() const { return m_stereo; }
    void setStereo(const Stereo& stereo);
    /// Turns as a drag does: the object follows to the right and downwards, by degrees.
    void turn(double rightwards, double downwards);
    /// As setCamera() in the midst of a movement: a quick picture is drawn first.
    void moveCamera(const Camera& camera);
    [[nodiscard]] bool takes(gpu::ViewId view) const override;
    void takeFrame(const gpu::Frame& frame) override;

Q_SIGNALS:
    void stereoChanged();

protected:
    [[nodiscard]] gpu::Scene scene() const override;
    [[nodiscard]] Gesture gestureFor(
        Qt::MouseButton button, const PointerSample& sample, bool toolWorksHere) const override;
    void dragged(Gesture gesture, const QPointF& from, const QPointF& to) override;
    bool clicked(const QPointF& at) override;
    void menuAsked(const QPointF& at) override;
    void activateSegmentAt(const QPointF& at) override;
    void hovered(const PointerSample& sample) override;
    void wheelTurned(double steps, const QPointF& at, Qt::KeyboardModifiers modifiers) override;
    void paintAnnotations(QPainter& painter, const ViewContext& shown) override;
    void requested(const gpu::FrameRequest& request) override;
    [[nodiscard]] QImage onScreen(const QImage& picture) const override;
    /// False for side-by-side stereo, where an overlay would have two places; tools do not work
    /// there either.
    [[nodiscard]] bool takesOverlays() const override;
    void resizeEvent(QResizeEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    /// Receives the place that is seen at a pixel; none: nothing is seen there.
    /// @return whether the user is to be told why there is none
    using PlaceAnswer = std::function<bool(const std::optional<glm::dvec3>& placeLps)>;
    void openVolume();
    /// Whether a pixel stands for one place in the volume. If not, tells the user why.
    [[nodiscard]] bool canBePointedAt() const;
    /// Asks which voxel is seen at a pixel.
    void askForPlace(const QPointF& at, const PlaceAnswer& then);
    void fit();
    void placeSwitch();
    [[nodiscard]] QStringList bottomTexts() const;
    void changeWindow(const QPointF& moved);
    [[nodiscard]] OrientationCube cube(const Camera& camera) const;
    [[nodiscard]] QString modeText() const;
    [[nodiscard]] QString qualityText() const;

    /// How far each eye is from the middle, in millimetres.
    [[nodiscard]] double eyeShiftMm() const;

    SeenReadout m_readout;
    ContextSwitch* m_switch;
    Stereo m_stereo;
    QImage m_otherEye; ///< the picture of the right eye
    Camera m_camera;
    bool m_fitted = true;
};

} // namespace ui
