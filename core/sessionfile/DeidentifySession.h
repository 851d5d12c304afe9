// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/deidentify/Deidentifier.h"

#include <QString>

namespace core {

/// What was done to a session file; ui::deidentifiedTexts() words it.
struct DeidentifiedSession {
    std::size_t steps = 0; ///< whose hashes were compared
    QString method; ///< Deidentifier::method()
    bool imagesLeftOut = false; ///< the session held the study's images

    bool operator==(const DeidentifiedSession&) const = default;
};

/// Makes a copy of a session file without what identifies the patient or the user: the path of the
/// study, its UIDs, description and date, authors, pictures, the state of the window, and the
/// study's images if it holds them. The times of steps are kept only where @p by keeps or shifts
/// dates. Chain and seals are computed anew. Differences and state hashes are the same, so the copy
/// replays to the same voxels on any copy of the study, which is recognised by its grid and the
/// checksum of its voxels alone.
///
/// Names of segments, layers and bookmarks belong to the hashed state and are kept. If one of them,
/// or any other text of a step, contains a word of the patient's identity (Deidentifier::words(),
/// holdsWord()), nothing is written. Finally the texts of the copy are searched byte by byte for
/// those of these words that are long enough for that. Blocks.
/// Errors: FileExists (unless @p replaceExisting), FileUnwritable, UnsupportedFormat (argument 1:
/// the step that names the patient, or that the session is damaged), and those of checkSession().
[[nodiscard]] Result<DeidentifiedSession> deidentifySession(
    const QString& file, const QString& target, bool replaceExisting, const Deidentifier& by);

} // namespace core
