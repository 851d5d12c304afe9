// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <QString>

namespace ui {

/// One sentence for a person: what went wrong, with which file or field, and why.
[[nodiscard]] QString errorText(const core::Error& error);

/// Why a session has no file (SessionStorage::whyNoFile()), as a clause that names the folder which
/// cannot be written.
[[nodiscard]] QString noFileText(const core::Error& why);

} // namespace ui
