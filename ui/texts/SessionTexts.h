// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sessionfile/DeidentifySession.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QStringList>

namespace ui {

/// "row 17 'Drill 5 mm' and the 5 after it cannot be read: …"
[[nodiscard]] QString damageText(const core::SessionDamage& damage);
/// What is damaged, without the file: of SessionDamaged, with or without lost rows.
[[nodiscard]] QString damageText(const core::Error& error);

/// Every problem of a session file as a sentence without a full stop, lost rows first; empty: none.
[[nodiscard]] QStringList problemTexts(const core::SessionContents& contents);

/// What was left out of a de-identified session and what was checked; one sentence each.
[[nodiscard]] QStringList deidentifiedTexts(const core::DeidentifiedSession& session);

} // namespace ui
