// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "tests/support/cases/StrokeCases.h"

#include <QByteArray>
#include <QString>

namespace test {

/// The state hashes after everything that can happen to an edit. Six of them must equal `finished`,
/// two `before`.
struct StrokeHashes {
    QByteArray before;
    QByteArray finished;
    QByteArray inPieces; ///< sent in pieces, as by a pen or a running growth
    QByteArray cancelled;
    QByteArray undone;
    QByteArray redone;
    QByteArray again; ///< undone and made again, on a second branch
    QByteArray reopened; ///< from the session file
    QByteArray replayed; ///< from the recorded edits, in a session of its own
    QString failure; ///< a refusal that must not occur
};

/// Runs a case through core::EditSession. The engine is used by nobody else meanwhile.
[[nodiscard]] StrokeHashes runStroke(core::EditEngine& engine, const StrokeCase& strokeCase);

/// What is inconsistent within the hashes, in words; empty if nothing is.
[[nodiscard]] QString contradiction(const StrokeHashes& hashes);
/// The difference between the hashes of two engines.
[[nodiscard]] QString difference(const StrokeHashes& expected, const StrokeHashes& actual);

} // namespace test
