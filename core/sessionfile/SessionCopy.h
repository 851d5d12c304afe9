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

/// All of a session that is at work, of its writer's thread.
struct SessionParts {
    SessionTables* tables = nullptr; ///< null: there is no file
    const SessionSource& source;
    const SessionWrites& waiting;
};

/// Into a staged file that is empty, or holds images and nothing else; with what waits.
[[nodiscard]] Result<void> copySessionInto(
    const QString& path, const SessionParts& parts, const SavedImages& images);

/// The same in a file that is to be committed at @p target. Where it fails nothing is left.
/// @param ownPlace what lies there is the session itself. Errors: FileExists, FileUnwritable.
[[nodiscard]] Result<std::shared_ptr<StagedFile>> stageSessionCopy(const QString& target,
    bool replaceExisting, bool ownPlace, const SessionParts& parts, const SavedImages& images);

} // namespace core
