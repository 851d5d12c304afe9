// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sessionfile/DeidentifySession.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QStringList>

namespace ui {

/// Describes damage of a session file as a clause: "row 17 'Drill 5 mm' and the 5 after it cannot
/// be read: …".
[[nodiscard]] QString damageText(const core::SessionDamage& damage);
/// Describes the damage that an error SessionDamaged reports, without the name of the file.
[[nodiscard]] QString damageText(const core::Error& error);

/// Returns every problem of a session file as a sentence without a full stop, lost rows first.
/// Empty if there are none.
[[nodiscard]] QStringList problemTexts(const core::SessionContents& contents);

/// Returns what was left out of a de-identified session and what was checked, one sentence each.
[[nodiscard]] QStringList deidentifiedTexts(const core::DeidentifiedSession& session);

} // namespace ui
