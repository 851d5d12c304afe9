// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "core/volume/encoding/VolumeEncoder.h"

#include <QString>
#include <QStringList>

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace core {

struct ModalityLut;

/// How a file stores its pixels (DICOM PS3.5 section 8).
struct PixelLayout {
    int columns = 0;
    int rows = 0;
    int samplesPerPixel = 1;
    int bitsAllocated = 0;
    int bitsStored = 0;
    int highBit = 0;
    /// The HighBit of the file if it is too low for the stored bits; highBit is then corrected.
    std::optional<int> falseHighBit{};
    bool isSigned = false;
    std::uint32_t overlayBits = 0; ///< those of a cell that hold overlays (60xx,0102)
    /// 32 or 64: pixels are floating-point numbers, and the bits above mean nothing
    int floatBits = 0;
    QString photometric;

    /// Pixels do not fit the 16 bits of stored values, and are decoded as numbers.
    [[nodiscard]] bool isWide() const { return floatBits != 0 || bitsAllocated > 16; }
};

/// Directions of increasing column and row index, unit vectors in LPS (PS3.3 C.7.6.2.1.1).
struct ImagePlane {
    glm::dvec3 row{1.0, 0.0, 0.0};
    glm::dvec3 column{0.0, 1.0, 0.0};

    [[nodiscard]] glm::dvec3 normal() const { return glm::cross(row, column); }
};

/// What Burin reads from the header of one image: a single-frame DICOM file, or one frame of a
/// multi-frame file. Plain data.
struct ImageHeader {
    QString file;
    StudyIdentity identity;
    QString sopInstanceUid;
    QString sopClassUid;
    QString transferSyntaxUid; ///< as the file states it; guessed if it does not
    QStringList imageType;
    Clause quantity; ///< what the values measure: "magnitude", "field map"; empty: not stated

    bool hasPixels = false;
    bool pixelsCut = false; ///< the file ends before its pixel data do
    bool isEnhanced = false; ///< geometry in functional groups
    bool hasModalityLut = false;
    std::shared_ptr<const ModalityLut> modalityLut{}; ///< null: none, or none that is usable
    bool isLossy = false;
    int frames = 1; ///< in the file
    int frame = 0; ///< which of them this is, 0-based
    bool framesUnplaced = false; ///< there are several frames without a position for each
    /// This header stands for this many frames of the file that have no functional group of their
    /// own; 0: for a single frame.
    int framesWithoutGroup = 0;
    /// Number of frames for which there are pixel data; none if it cannot be determined beforehand.
    std::optional<int> framesPresent{};
    PixelLayout layout;

    std::optional<glm::dvec3> position; ///< centre of the first pixel, LPS mm
    std::optional<ImagePlane> plane;
    std::optional<glm::dvec2> spacing; ///< mm between columns (x) and between rows (y)
    double sliceThickness = 0.0; ///< 0: absent
    double spacingBetweenSlices = 0.0; ///< 0: absent

    bool hasRescale = false;
    double slope = 1.0;
    double intercept = 0.0;
    QString rescaleType;
    QString units; ///< (0054,1001), PET; (3004,0002), dose
    QString suvType; ///< (0054,1006), PET: to what uptake is related; empty: body weight
    std::optional<WindowLevel> window;
    bool inverted = false; ///< high values are displayed dark; the values themselves are unchanged
    std::optional<StoredRange> padding{}; ///< stored values of pixels outside the scanned region

    int instanceNumber = 0;
    QString stackId; ///< for a frame: the stack of its file to which it belongs; may be empty
    /// Values that may distinguish images at one position, most significant first; empty if absent.
    /// Every image has the same attributes in the same order (core/dicom/header/PhaseAttributes.h).
    std::vector<QString> phases;
};

} // namespace core
