// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

namespace core {

class StagedFile;

/// An error about a file that is being staged, as its user knows it: the target is named wherever
/// the error named the hidden file.
[[nodiscard]] Error namingTarget(Error error, const StagedFile& staged);

} // namespace core
