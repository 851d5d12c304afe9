// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/deidentify/Deidentifier.h"

#include <QString>
#include <QStringList>

namespace core {

/// A copy of a session file without what tells of the patient or the user: where the study was, its
/// UIDs, description and date, authors, pictures, how the window looked, and the study's images
/// where it holds them. When steps were done stays only where @p by keeps or shifts dates. Chain
/// and seals are made anew; differences and state hashes are the same, so it replays to the same
/// voxels on any copy of the study: that is known again by its grid and its voxels' checksum alone.
///
/// Names of segments, layers and bookmarks belong to the hashed state and stay. Where one of them,
/// or any other text of a step, holds a word of the patient's identity (Deidentifier::words()),
/// nothing is written. Then the copy is searched for all of them, byte by byte in its texts.
/// Blocks.
/// @returns what was left out and checked, in sentences
/// Errors: FileExists (unless @p replaceExisting), FileUnwritable, UnsupportedFormat (argument 1:
/// the step that names the patient, or that the session is damaged), and those of checkSession().
[[nodiscard]] Result<QStringList> deidentifySession(
    const QString& file, const QString& target, bool replaceExisting, const Deidentifier& by);

} // namespace core
