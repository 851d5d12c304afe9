// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clauses.h"

namespace core {

/// The kind of a failure. ui::errorText() makes the sentence for the user from code and arguments.
enum class ErrorCode {
    // Files and folders: argument 0 is the path, argument 1 (optional) the reason.
    FileNotFound,
    FileUnreadable,
    FileTruncated,
    FileExists,
    FileUnwritable,
    FolderEmpty,
    TooManyFiles, ///< below the folder; argument 1: the number that is searched at most
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
    // Export: argument 0 is the file, argument 1 what does not match.
    ExportMismatch,
    SegmentNotCoded,
    NothingToExport,
    /// seeds and painted voxels of a growth cannot be removed; argument 0: how many were requested
    SeedsStay,
    NothingGrown, ///< at the places where a growth was to be removed
    EverythingGrown, ///< would be removed
    NoIslandThere, ///< at the place that was clicked; argument 0: the segment's name
    /// more than can become segments; argument 0: the segment's name, 1: how many there are beside
    /// the largest, 2: how many more segments there can be
    TooManyIslands,
    StepsEntangled, ///< argument 0: why steps cannot be undone alone
    // Session: argument 0 is the file, argument 1 the reason.
    SessionDamaged,
    SessionMismatch,
    SessionUnwritten, ///< work continues in memory; argument 1: the error of the disk
    /// another program took its name, so it continues in this file; argument 2: the file before
    SessionMoved,
    SessionReadOnly, ///< it was opened for viewing; argument 1: why
    StudyMissing, ///< argument 1: where the session's study was
    // Machine.
    GraphicsUnavailable,
    OutOfMemory,
    EngineLost, ///< its voxels no longer match the session; argument 0: why
    ContextLost, ///< the graphics driver lost the context and everything in it; argument 0: why
    Cancelled,
    Internal,
    // Other machines (PACS): argument 0 is the node, as PacsNode::name() returns it.
    NodeUnreachable, ///< argument 1: why
    NodeRejects, ///< it rejects the association; argument 1: why
    NodeRefuses, ///< argument 1: the service or kind of object that it does not accept
    NodeTimeout, ///< argument 1: after how many seconds without a response
    NodeLost, ///< the connection ended before the work was done; argument 1 (optional): why
    NodeNonsense, ///< its answer is not DICOM; argument 1: what is wrong
    NodeFailed, ///< it reports a failure; argument 1: the request; 2: its status
    NodeHasNone, ///< argument 1: what it does not have
    TransferIncomplete, ///< argument 1: how many of how many are missing; 2 (optional): why
};

/// A failure that crosses layers as a value.
struct Error {
    ErrorCode code = ErrorCode::Internal;
    Clauses arguments;
};

/// Whether the sentence for this code gives no reason. For these codes the entry of a recipe in
/// which the error occurred is an argument of its own, entryArgument; for all others it follows the
/// reason.
[[nodiscard]] constexpr bool givesNoReason(ErrorCode code)
{
    return code == ErrorCode::SegmentLocked || code == ErrorCode::SegmentProtected
        || code == ErrorCode::SeedsStay || code == ErrorCode::NothingGrown
        || code == ErrorCode::EverythingGrown || code == ErrorCode::NoIslandThere
        || code == ErrorCode::TooManyIslands || code == ErrorCode::StepsEntangled;
}
inline constexpr qsizetype entryArgument = 3;

} // namespace core
