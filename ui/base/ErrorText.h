// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <QString>

namespace ui {

/// One sentence for a person: what went wrong, with which file or field, and why.
[[nodiscard]] QString errorText(const core::Error& error);

/// Why a session has no file (SessionStorage::whyNoFile()), in a clause: which folder takes none.
[[nodiscard]] QString noFileText(const core::Error& why);

} // namespace ui
