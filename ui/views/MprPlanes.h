// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewPlane.h"

#include <QObject>

#include <array>

namespace ui {

/// The planes of the three slice views, which all pass through the crosshair. At first they lie
/// along the patient's axes; each can be rotated about the normal of another one (double oblique).
/// Rotations are not steps of undo.
class MprPlanes : public QObject {
    Q_OBJECT

public:
    static constexpr std::array<SliceOrientation, 3> all{
        SliceOrientation::Axial, SliceOrientation::Sagittal, SliceOrientation::Coronal};

    explicit MprPlanes(QObject* parent = nullptr);

    [[nodiscard]] const SliceAxes& axes(SliceOrientation plane) const;
    /// Whether all three planes lie as they did at first.
    [[nodiscard]] bool alongPatient() const;
    /// Puts all three planes back to the patient's axes.
    void reset();

    /// Rotates the two planes that appear as lines in a slice. Planes that are perpendicular to
    /// each other stay so.
    /// @param seenIn the slice, which is not rotated
    /// @param radians clockwise in the slice when it is upright
    void turnOthers(SliceOrientation seenIn, double radians);
    /// Rotates only one of these planes. It does nothing if that plane would come nearer than about
    /// 10° to another one.
    void turnOne(SliceOrientation seenIn, SliceOrientation plane, double radians);
    /// Sets a plane.
    /// @param rightLps, downLps unit vectors, perpendicular to each other
    void set(SliceOrientation plane, const glm::dvec3& rightLps, const glm::dvec3& downLps);

Q_SIGNALS:
    void changed();

private:
    std::array<SliceAxes, 3> m_axes;
};

} // namespace ui
