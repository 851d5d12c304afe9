// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/records/SavedImages.h"

#include <QString>

#include <memory>

namespace core {

class SessionTables;
class SessionWrites;
class StagedFile;
struct SessionSource;

/// What a session in use consists of, for its writer's thread.
struct SessionParts {
    SessionTables* tables = nullptr; ///< null: there is no file
    const SessionSource& source;
    const SessionWrites& waiting;
};

/// Copies a session, with the writes that are waiting, into a staged file that is empty or holds
/// only images.
[[nodiscard]] Result<void> copySessionInto(
    const QString& path, const SessionParts& parts, const SavedImages& images);

/// Makes such a copy in a new file that is to be committed at @p target. If it fails, nothing
/// remains.
/// @param ownPlace whether the session itself lies at @p target
/// Errors: FileExists, FileUnwritable.
[[nodiscard]] Result<std::shared_ptr<StagedFile>> stageSessionCopy(const QString& target,
    bool replaceExisting, bool ownPlace, const SessionParts& parts, const SavedImages& images);

} // namespace core
