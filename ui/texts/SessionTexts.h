// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sessionfile/DeidentifySession.h"

#include <QStringList>

namespace ui {

/// What was left out of a de-identified session and what was checked; one sentence each.
[[nodiscard]] QStringList deidentifiedTexts(const core::DeidentifiedSession& session);

} // namespace ui
