// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QString>
#include <QStringList>

namespace test {

/// What tests/data/gold holds to: recipes that carry out every kind of edit there is, with undo,
/// branches, revisions and "undo only", on a study made for them; the sessions that they left when
/// they were recorded; and, as text, what came of each step and row.

/// The small study, and beside its ball two smaller ones with a tube between them: a neck, and what
/// leaks through it.
[[nodiscard]] core::LoadedVolume goldenStudy();

[[nodiscard]] QString goldenFolder();
/// Of the recipes, without ".json", sorted.
[[nodiscard]] QStringList goldenNames();

/// What a closed session file holds of each row, a line each: number, parent, the growth's
/// generation, state hash, hash of its difference, name, edit. Nothing that depends on time, user
/// or machine.
[[nodiscard]] QString rowsOf(const QString& sessionFile);

/// Holds @p text to a file of tests/data/gold; with BURIN_RECORD_GOLD set it becomes the file.
/// @return the first line that differs, beside the one that was expected; empty: none
[[nodiscard]] QString differenceFromGold(const QString& name, const QString& text);

} // namespace test
