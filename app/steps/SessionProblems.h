// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {
struct Error;
struct SessionContents;
} // namespace core

namespace app {

// How commands treat a damaged session: they deliver the sound part of what was requested, name the
// rest in one sentence on stderr, and end with 0 if nothing that was requested is lost, else with
// 1.

/// Reports what core::checkSession() found damaged, if anything, and which files of another session
/// lie beside it.
void reportProblems(const QString& file, const core::SessionContents& contents);

/// Reports for a session that is continued what may be missing although nothing is damaged, and
/// which files of another session lie beside it.
void reportLeft(const QString& file, const core::SessionContents& contents);

/// Reports why a session could not be followed to its new name, and which of its files lie beside
/// the file that has its name now. @return the status with which the command ends
int reportUnfollowed(const core::Error& why, const QString& file);

} // namespace app
