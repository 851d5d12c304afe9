// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

namespace core {

class StagedFile;

/// Rewrites an error about a staged file for the user: the target's name replaces that of the
/// hidden file.
[[nodiscard]] Error namingTarget(Error error, const StagedFile& staged);

/// Why something failed, and that what was in the file @p path is in the file @p left beside it.
[[nodiscard]] Clause leftElsewhere(const Clause& why, const QString& path, const QString& left);

/// Undoes a commit() because a later step failed with @p error.
/// @return the error, with the place of the replaced file if that could not get its name back
[[nodiscard]] Error takingBack(Error error, StagedFile& staged);

} // namespace core
