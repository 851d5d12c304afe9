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

/// Traces the contour of the value under the pointer (core/outline/LevelContour.h) on a background
/// thread. If the pointer moves faster than that, places in between are skipped and the last
/// contour stays. GUI thread.
class LevelTrace : public QObject {
    Q_OBJECT

public:
    /// @param slice holds the values in which contours are traced; must outlive this
    LevelTrace(Workspace& workspace, ReadSlice& slice, QObject* parent = nullptr);

    /// Forgets the pointer and the contour.
    void drop();
    /// Starts to trace the contour at a place of the slice (LPS mm).
    void pointAt(const glm::dvec3& placeLps);

    /// Whether the pointer is on a pixel of the slice.
    [[nodiscard]] bool pointsAtPixel() const { return m_pixel.has_value(); }
    /// Whether contour() belongs to the pixel under the pointer.
    [[nodiscard]] bool isKnown() const { return m_pixel && m_pixel == m_tracedPixel; }
    /// The last contour traced in the slice. None before the first, and after the pointer has left
    /// the slice.
    [[nodiscard]] const std::optional<core::LevelContour>& contour() const { return m_contour; }
    /// The corners of contour() in LPS mm; empty if there is none.
    [[nodiscard]] std::vector<glm::dvec3> contourLps() const;

Q_SIGNALS:
    void changed();
    void failed(); ///< tracing failed; the workspace has told the user why

private:
    void proceed();

    Workspace& m_workspace;
    ReadSlice& m_slice;
    std::optional<glm::ivec2> m_pixel; ///< the pixel under the pointer
    std::optional<glm::ivec2> m_tracedPixel; ///< the pixel of m_contour
    std::optional<core::LevelContour> m_contour;
    core::Background m_background;
};

} // namespace ui
