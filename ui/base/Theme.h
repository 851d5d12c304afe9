// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QFont>

class QApplication;

namespace ui::theme {

/// The one palette of the window: a dark reading room, near-black greys, one accent.
/// Text colours keep a contrast of at least 4.5 : 1 on `panel`.
inline constexpr QColor window{0x16, 0x18, 0x1c};
inline constexpr QColor panel{0x1e, 0x21, 0x26};
inline constexpr QColor raised{0x25, 0x29, 0x30};
inline constexpr QColor line{0x34, 0x3a, 0x43};
inline constexpr QColor text{0xd7, 0xdc, 0xe3};
inline constexpr QColor secondary{0x8b, 0x94, 0xa1};
inline constexpr QColor faint{0x5d, 0x65, 0x70}; ///< things that are off, and their marks
inline constexpr QColor accent{0x4a, 0xa3, 0xff};
inline constexpr QColor selected{0x21, 0x36, 0x4f}; ///< a chosen row or tool
inline constexpr QColor good{0x59, 0xc0, 0x7a};
inline constexpr QColor caution{0xf0, 0xb0, 0x4a};
inline constexpr QColor bad{0xef, 0x6a, 0x5b};
inline constexpr QColor picture{0x00, 0x00, 0x00}; ///< behind images
inline constexpr QColor axial{0xe0, 0x52, 0x4a};
inline constexpr QColor sagittal{0xe6, 0xc8, 0x4a};
inline constexpr QColor coronal{0x5b, 0xbf, 0x6a};
inline constexpr QColor volume{0xd7, 0xb1, 0x3f};
inline constexpr QColor plane{0x5a, 0xa9, 0xe6}; ///< the cutting plane; gpu::ScenePlane's rim

// Sizes in logical pixels, on a grid of 4.
inline constexpr int smallPadding = 8;
inline constexpr int padding = 14;
inline constexpr int rowHeight = 28;
inline constexpr int controlHeight = 24;
inline constexpr int cornerRadius = 4;
inline constexpr int iconSize = 20;
inline constexpr int toolTarget = 44;
inline constexpr int viewBarHeight = 3;

/// 13 px body text; Inter where it is installed, else the system's sans serif.
[[nodiscard]] QFont bodyFont();
/// 12.5 px semibold.
[[nodiscard]] QFont headingFont();
/// 11.5 px.
[[nodiscard]] QFont smallFont();

/// Fusion style, palette, font and style sheet for the whole program.
void apply(QApplication& application);

} // namespace ui::theme
