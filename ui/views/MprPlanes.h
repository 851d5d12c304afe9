// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewPlane.h"

#include <QObject>

#include <array>

namespace ui {

/// The planes of the three slice views, which all pass through the crosshair. At first they lie
/// along the patient; each can be turned about the normal of another one (double oblique). It is
/// not a step of undo.
class MprPlanes : public QObject {
    Q_OBJECT

public:
    static constexpr std::array<SliceOrientation, 3> all{
        SliceOrientation::Axial, SliceOrientation::Sagittal, SliceOrientation::Coronal};

    explicit MprPlanes(QObject* parent = nullptr);

    [[nodiscard]] const SliceAxes& axes(SliceOrientation plane) const;
    /// Whether all three lie as they did at first.
    [[nodiscard]] bool alongPatient() const;
    void reset();

    /// Turns the two planes that are seen as lines in a slice, which themselves stay perpendicular
    /// to each other if they are so.
    /// @param seenIn the slice, which is not turned
    /// @param radians clockwise as the slice is seen upright
    void turnOthers(SliceOrientation seenIn, double radians);
    /// Turns only one of them. It does not come so near to another plane that both would be one.
    void turnOne(SliceOrientation seenIn, SliceOrientation plane, double radians);
    /// @param rightLps, downLps unit, perpendicular to each other
    void set(SliceOrientation plane, const glm::dvec3& rightLps, const glm::dvec3& downLps);

Q_SIGNALS:
    void changed();

private:
    std::array<SliceAxes, 3> m_axes;
};

} // namespace ui
