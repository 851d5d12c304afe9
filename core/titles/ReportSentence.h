// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Said.h"
#include "core/volume/ProblemSentence.h"

#include <QList>
#include <QStringList>

#include <cstdint>
#include <variant>

namespace core {

/// What the report of an export says, or a part of that; ui/texts/ReportTexts.h words it.
enum class ReportCode : std::uint8_t {
    // Parts of sentences, and what stands between two of them.
    Joined,
    Comma,
    Space,
    Quoted,
    Segments,
    Frames,
    Contours,
    Numbers,
    SourceHeaders,
    SourceGrid,
    RepairedGrid,
    BinarySeg,
    FractionalSeg,
    LabelMapSeg,
    DeflatedSeg,
    AsLayerCovers,
    SurfaceOf,
    VolumeOf,
    // Formats, as ui/texts/ExportFormatTexts.h calls them.
    StlFormat,
    ObjFormat,
    PlyFormat,
    GltfFormat,
    CsvFormat,
    JsonFormat,
    SrFormat,
    // What was written.
    DicomSeg,
    FilledInPart,
    WithoutCoverage,
    RtStruct,
    NiftiLabelMap,
    SlicerSegmentation,
    Surfaces,
    SurfacesSmoothed,
    Statistics,
    SinceImport,
    SegBeside,
    OnOwnSlices,
    Deidentified,
    CarvedVolume,
    NiftiFloats,
    NiftiWholeNumbers,
    CarvedSeries,
    LayerCoverage,
    SecondaryCapture,
    PngPicture,
    // What was checked.
    FramesAgree,
    VoxelsOfAsDrawn,
    ContoursInPlanes,
    ContoursFilled,
    CornersOnSource,
    CornersOnStudy,
    VoxelsAsDrawn,
    NamesAsGiven,
    TrianglesClosed,
    CentresInside,
    NumbersEqual,
    VoxelsAsTheyShould,
    SeriesAsItShould,
    SlicesFoundAgain,
    PixelsAgree,
    TextsTellNobody,
    FilesTellNobody,
    Sha256,
    // What a reader of the file must know.
    SegmentEmpty,
    CheckedAgainstSession,
    Repaired,
    BeyondImages,
    TiltInFile,
    TiltInSform,
    UnevenInFile,
    UnevenInNifti,
    UnevenInVolumes,
    ValuesRounded,
    LabelMapsAreNew,
    NoFrameOfReference,
    NewFrameOfReference,
    OneStlSurface,
    FaceCanBeRecognised,
    StillLossy,
    ValueLeftOut,
    ValueNormalised,
};

using ReportSentence = Said<ReportCode>;

/// One line of a report: of the export itself, or of a problem that its volume has.
using ReportLine = std::variant<ReportSentence, ProblemSentence>;
using ReportLines = QList<ReportLine>;

/// Parts of a sentence, with commas.
[[nodiscard]] ReportSentence::Argument inReport(std::vector<ReportSentence> parts);
[[nodiscard]] ReportSentence::Argument inReport(ReportSentence part);
/// Names, with commas.
[[nodiscard]] ReportSentence::Argument namesInReport(const QStringList& names);
/// "1 frame", "2 frames".
/// @param noun one that is a count
[[nodiscard]] ReportSentence::Argument countedInReport(ReportCode noun, std::int64_t count);

} // namespace core
