// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

namespace ui {

/// How the 3D view shows a picture for each eye (seed B §3). Quad-buffered output is not offered:
/// it would need a native OpenGL window, but views are images (README).
struct Stereo {
    enum class Mode {
        Off,
        Anaglyph, ///< red for the left eye, green and blue for the right one
        /// The left eye's picture on the left, both squeezed to half width, as stereo screens
        /// expect.
        SideBySide,
    };
    static constexpr double leastDegrees = 0.5;
    static constexpr double mostDegrees = 12.0;
    Mode mode = Mode::Off;
    double eyesDegrees = 3.0; ///< angle between the directions of both eyes to the target
    bool swapped = false; ///< exchanges the pictures of both eyes
    bool operator==(const Stereo&) const = default;
};

/// Combines the pictures of both eyes, which have the same size, into one.
[[nodiscard]] QImage composed(Stereo::Mode mode, const QImage& left, const QImage& right);

} // namespace ui
