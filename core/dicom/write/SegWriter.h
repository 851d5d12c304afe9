// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/write/SegSettings.h"
#include "core/document/Document.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace core {

class Deidentifier;

/// Packs the bits of frames one after the other: least significant first, without gaps between
/// frames, padded to a whole number of 16-bit words at the very end (PS3.5 8.1.1). This is our own
/// code because dcmseg 3.6.7 loses bits if rows × columns is not a multiple of 8.
class FrameBits {
public:
    /// Appends one frame: 1 where a label equals @p label.
    void append(std::span<const std::uint8_t> labels, std::uint8_t label);
    /// The padded bytes; call once, at the end.
    [[nodiscard]] std::vector<std::uint8_t> take();

private:
    std::vector<std::uint8_t> m_bytes;
    std::uint64_t m_bits = 0;
};

/// The contents of a DICOM SEG to be written. Frames are ordered by segment, then by slice.
struct SegContent {
    enum class Type {
        Binary,
        Fractional, ///< of type OCCUPANCY; 255 is the whole pixel
        LabelMap, ///< for writeLabelMapSeg()
    };
    struct Frame {
        int segment = 0; ///< index into `segments`; not used for a label map
        int slice = 0; ///< index into `sources`
    };

    StudyIdentity identity; ///< of the source, as it was loaded
    QString repair; ///< how the series was repaired on loading (repairMade()); empty: not at all
    std::vector<SourceSlice> sources;
    std::shared_ptr<const KeptHeaders> keptHeaders; ///< replaces these; null: their files are read
    int columns = 0;
    int rows = 0;
    /// Distance of neighbouring slices along their normal; 0 if it varies.
    double sliceDistanceMm = 0.0;
    std::vector<Segment> segments; ///< each coded, each with a frame
    CodedConcept category;
    bool segmentsOverlap = false;
    std::vector<Frame> frames;
    Type type = Type::Binary;
    /// In the order of `frames`: FrameBits::take() for Binary; for the other types one byte per
    /// pixel.
    std::vector<std::uint8_t> pixels;
    SegSettings settings{};
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient's identity is kept
};

/// The result of writing.
struct SegWritten {
    /// Sentences on invalid parts of the source's header that were normalised or left out.
    ReportLines notes;
};

/// Writes a BINARY or FRACTIONAL DICOM SEG (PS3.3 A.51) to @p path, which is created or
/// overwritten.
///
/// Patient, study and frame of reference are those of the source's header; positions, orientations
/// and spacings are its exact text. UIDs are new. Reads the header of every source. Any thread.
/// Errors: FileUnreadable and FileNotFound (a source), UnsupportedFormat (what the source lacks),
/// InvalidField (a code or name that DICOM does not allow), FileUnwritable, Cancelled, Internal.
Result<SegWritten> writeSeg(
    const QString& path, const SegContent& content, const Progress& progress);

} // namespace core
