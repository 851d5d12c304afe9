// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QString>
#include <QStringList>

namespace test {

/// Access to tests/data/gold: recipes that carry out every kind of edit, with undo, branches,
/// revisions and "undo only", on a study made for them; the sessions that resulted when they were
/// recorded; and, as text, the result of each step and row.

/// The small study with two smaller balls beside its ball, connected by a tube: a neck with
/// something that leaks through it.
[[nodiscard]] core::LoadedVolume goldenStudy();

[[nodiscard]] QString goldenFolder();
/// The names of the recipes, without ".json", sorted.
[[nodiscard]] QStringList goldenNames();

/// What a closed session file holds for each row, one line each: number, parent, generation of the
/// growth, state hash, hash of its difference, name, edit. Nothing in it depends on time, user or
/// machine.
[[nodiscard]] QString rowsOf(const QString& sessionFile);

/// Compares @p text with a file of tests/data/gold; if BURIN_RECORD_GOLD is set it replaces the
/// file instead.
/// @return the first line that differs, beside the expected one; empty if none
[[nodiscard]] QString differenceFromGold(const QString& name, const QString& text);

} // namespace test
