// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

namespace ui {

/// How the 3D view shows what both eyes see (seed B §3). Quad-buffered output would need a window
/// of OpenGL's own; views are images (README).
struct Stereo {
    enum class Mode {
        Off,
        Anaglyph, ///< red for the left eye, green and blue for the right one
        SideBySide, ///< the left eye's half on the left, each squeezed: as stereo screens take it
    };
    static constexpr double leastDegrees = 0.5;
    static constexpr double mostDegrees = 12.0;
    Mode mode = Mode::Off;
    double eyesDegrees = 3.0; ///< between both eyes' directions to what they look at
    bool swapped = false; ///< the right eye's picture for the left one
    bool operator==(const Stereo&) const = default;
};

/// One picture of two of one size.
[[nodiscard]] QImage composed(Stereo::Mode mode, const QImage& left, const QImage& right);

} // namespace ui
