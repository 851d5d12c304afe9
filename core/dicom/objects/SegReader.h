// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/source/SourceHeader.h"
#include "core/document/Document.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// One item of SegmentSequence (PS3.3 C.8.20.2).
struct SegSegment {
    int number = 0;
    QString label;
    CodedConcept category;
    CodedConcept type;
    QString algorithmType;
    QString algorithmName;
    std::optional<std::array<std::uint16_t, 3>> cieLab; ///< PS3.3 C.10.7.1.1
    std::optional<std::uint32_t> rgb; ///< 0xRRGGBB, that colour on a screen
};

/// One frame: the pixels of one segment in one plane.
struct SegFrame {
    int segment = 0; ///< SegSegment::number
    HeaderPlane plane;
    QString referencedSopUid; ///< the source image; empty if none is stated
    int referencedFrame = 0; ///< 0-based
};

/// The contents of a DICOM SEG, unchanged.
struct SegFile {
    enum class Type {
        Binary,
        Fractional, ///< a pixel states how much of it belongs to the frame's segment
        LabelMap, ///< a pixel is the number of its segment; the frame's own number means nothing
    };
    Type type = Type::Binary;
    HeaderPatient patient;
    QString studyUid;
    QString seriesUid;
    QString sopInstanceUid;
    QString frameOfReferenceUid;
    QString segmentsOverlap; ///< YES, NO, UNDEFINED or empty
    QStringList referencedSopUids; ///< of ReferencedSeriesSequence
    int rows = 0;
    int columns = 0;
    std::vector<SegSegment> segments;
    std::vector<SegFrame> frames;
    /// SpacingBetweenSlices, else SliceThickness; 0: neither is present
    double planeDistance = 0.0;
    double spacingBetweenSlices = 0.0; ///< 0: not stated
    int fullPixel = 1; ///< for a fractional SEG: MaximumFractionalValue
    int bitsPerPixel = 1; ///< 1, 8 or 16
    /// PS3.5 8.1.1: least significant bit and byte first, frames without gaps.
    std::vector<std::uint8_t> bits;

    /// @pre of type BINARY
    [[nodiscard]] bool pixel(std::size_t frame, int column, int row) const;
    [[nodiscard]] int value(std::size_t frame, int column, int row) const;
};

/// Reads a DICOM SEG without dcmseg, which reads and writes bits incorrectly. Cost: the file is
/// read once. Any thread outside a parallelFor(). Errors: FileNotFound, FileUnreadable,
/// UnsupportedFormat (not a SEG, or of another type than the three), InvalidGeometry (a frame
/// without a position), and those of segPixels().
Result<SegFile> readSeg(const QString& path);

} // namespace core
