// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "core/volume/encoding/VolumeEncoder.h"

#include <QString>
#include <QStringList>

#include <glm/glm.hpp>

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
    bool isSigned = false;
    int floatBits = 0; ///< 32 or 64: pixels are floating-point numbers, bits say nothing
    QString photometric;
};

/// Directions of increasing column and row index, unit vectors in LPS (PS3.3 C.7.6.2.1.1).
struct ImagePlane {
    glm::dvec3 row{1.0, 0.0, 0.0};
    glm::dvec3 column{0.0, 1.0, 0.0};

    [[nodiscard]] glm::dvec3 normal() const { return glm::cross(row, column); }
};

/// What Burin reads from the header of one image: of a single-frame DICOM file, or of one frame of
/// a multi-frame one. Plain data.
struct ImageHeader {
    QString file;
    StudyIdentity identity;
    QString sopInstanceUid;
    QString sopClassUid;
    QString transferSyntaxUid; ///< as the file says; the guess where it does not
    QStringList imageType;
    QString quantity; ///< what the values measure: "magnitude", "field map"; empty: nothing says

    bool hasPixels = false;
    bool pixelsCut = false; ///< the file ends before its pixel data do
    bool isEnhanced = false; ///< geometry in functional groups
    bool hasModalityLut = false;
    std::shared_ptr<const ModalityLut> modalityLut{}; ///< null: none, or none that can be used
    bool isLossy = false;
    int frames = 1; ///< in the file
    int frame = 0; ///< which of them this is, 0-based
    bool framesUnplaced = false; ///< several frames, and nothing says where each of them lies
    /// How many frames the pixel data have room for; none where that cannot be told beforehand.
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
    QString units; ///< (0054,1001), PET
    std::optional<WindowLevel> window;
    bool inverted = false; ///< shown dark where values are high; the values are what they are
    std::optional<StoredRange> padding{}; ///< stored values of pixels outside what was scanned

    int instanceNumber = 0;
    QString stackId; ///< of a frame: which stack of its file it belongs to; may be empty
    /// Values that may tell images at one position apart, most telling first; empty where absent.
    /// Same attributes in the same order for every image (core/dicom/header/PhaseAttributes.h).
    std::vector<QString> phases;
};

} // namespace core
