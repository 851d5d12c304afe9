// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/outline/LevelContour.h"

#include <QObject>

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace ui {

class ReadSlice;
class Workspace;

/// The contour of the value under the pointer (core/outline/LevelContour.h), worked out on another
/// thread. While the pointer moves faster than that goes, contours of some places are left out, and
/// the last one is shown.
class LevelTrace : public QObject {
    Q_OBJECT

public:
    /// @param slice in which is pointed; must outlive this
    LevelTrace(Workspace& workspace, ReadSlice& slice, QObject* parent = nullptr);

    void drop();
    void pointAt(const glm::dvec3& placeLps);

    /// Whether there is a pixel under the pointer.
    [[nodiscard]] bool pointsAtPixel() const { return m_pixel.has_value(); }
    /// Whether contour() is that of the pixel under the pointer.
    [[nodiscard]] bool isKnown() const { return m_pixel && m_pixel == m_tracedPixel; }
    /// The last one that was traced in the slice; none before the first, and beside the slice.
    [[nodiscard]] const std::optional<core::LevelContour>& contour() const { return m_contour; }
    /// Its corners; empty if there is none.
    [[nodiscard]] std::vector<glm::dvec3> contourLps() const;

Q_SIGNALS:
    void changed();
    void failed(); ///< it could not be traced, as the workspace says

private:
    void proceed();

    Workspace& m_workspace;
    ReadSlice& m_slice;
    std::optional<glm::ivec2> m_pixel; ///< under the pointer
    std::optional<glm::ivec2> m_tracedPixel; ///< of the contour
    std::optional<core::LevelContour> m_contour;
    core::Background m_background;
};

} // namespace ui
