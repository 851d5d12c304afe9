// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

namespace core {

/// What went wrong. The sentence for a person is made by ui::errorText() from code and arguments.
enum class ErrorCode {
    // Files and folders: argument 0 is the path, argument 1 (optional) the reason.
    FileNotFound,
    FileUnreadable,
    FileTruncated,
    FileExists,
    FileUnwritable,
    FolderEmpty,
    TooManyFiles, ///< below the folder; argument 1: how many are looked through
    NoImages,
    UnsupportedFormat,
    InvalidGeometry,
    // A choice is needed: argument 0 is the path, the rest one line per candidate.
    SeriesAmbiguous,
    SeriesNotFound,
    // Edits and recipes: argument 0 names the edit or field, argument 1 the reason.
    UnknownEdit,
    InvalidField,
    SeedOutsideVolume,
    UnknownSegment,
    SegmentLocked, ///< argument 0: its name; none: every segment is
    SegmentProtected, ///< from sculpting; argument 0: its name
    InvalidRecipe,
    // Export: argument 0 is the file, argument 1 what does not agree.
    ExportMismatch,
    SegmentNotCoded,
    NothingToExport,
    SeedsStay, ///< of a growth, and what was painted; argument 0: how many were to be taken back
    NothingGrown, ///< where a growth was to be taken back
    StepsEntangled, ///< argument 0: why steps cannot be undone alone
    // Session: argument 0 is the file, argument 1 the reason.
    SessionDamaged,
    SessionMismatch,
    SessionUnwritten, ///< work goes on in memory; argument 1 is what the disk said
    SessionReadOnly, ///< it is looked at only; argument 1: why
    StudyMissing, ///< argument 1: where the session's study was
    // Machine.
    GraphicsUnavailable,
    OutOfMemory,
    EngineLost, ///< its voxels are not the session's any more; argument 0: why
    ContextLost, ///< the graphics driver gave its context up, and all in it; argument 0: why
    Cancelled,
    Internal,
    // Other machines (PACS): argument 0 is the node, as PacsNode::name() has it.
    NodeUnreachable, ///< argument 1: why
    NodeRejects, ///< the association; argument 1: why
    NodeRefuses, ///< argument 1: the service or kind of object that it does not take
    NodeTimeout, ///< argument 1: after how many seconds without a sign of life
    NodeLost, ///< the connection ended before the work did; argument 1 (optional): why
    NodeNonsense, ///< what it says is not DICOM; argument 1: what
    NodeFailed, ///< it says that it could not; argument 1: what it was asked; 2: its status
    NodeHasNone, ///< argument 1: of what
    TransferIncomplete, ///< argument 1: how many of how many are missing; 2 (optional): why
};

/// A failure that crosses layers as a value.
struct Error {
    ErrorCode code = ErrorCode::Internal;
    QStringList arguments;
};

} // namespace core
