// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Said.h"
#include "core/volume/ProblemSentence.h"

#include <QList>
#include <QStringList>

#include <cstdint>
#include <variant>

namespace core {

/// A sentence in the report of an export, or a part of one; ui/texts/ReportTexts.h puts it into
/// words.
enum class ReportCode : std::uint8_t {
    // Parts of sentences, and separators between them.
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
    TrianglesOf,
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
    TextsAreAnonymous,
    FilesAreAnonymous,
    Sha256,
    // What a reader of the file must know.
    SegmentEmpty,
    CheckedAgainstSession,
    Repaired,
    BeyondImages,
    TiltInFile,
    TiltInSform,
    UnevenInFile,
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

/// One line of a report: a sentence about the export, or a problem of its volume.
using ReportLine = std::variant<ReportSentence, ProblemSentence>;
using ReportLines = QList<ReportLine>;

/// Inserts parts of a sentence as an argument, separated by commas.
[[nodiscard]] ReportSentence::Argument inReport(std::vector<ReportSentence> parts);
[[nodiscard]] ReportSentence::Argument inReport(ReportSentence part);
/// Inserts names as an argument, separated by commas.
[[nodiscard]] ReportSentence::Argument namesInReport(const QStringList& names);
/// Inserts a count with its noun as an argument, such as "1 frame" or "2 frames".
/// @param noun a code whose sentence is a counted noun, such as ReportCode::Frames
[[nodiscard]] ReportSentence::Argument countedInReport(ReportCode noun, std::int64_t count);

} // namespace core
