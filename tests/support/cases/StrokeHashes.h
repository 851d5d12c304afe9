// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "tests/support/cases/StrokeCases.h"

#include <QByteArray>
#include <QString>

namespace test {

/// The state hashes before an edit and after it.
struct StrokeEnds {
    QByteArray before;
    QByteArray finished;
    QString failure; ///< a refusal that must not occur
};

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

    [[nodiscard]] StrokeEnds ends() const
    {
        return {.before = before, .finished = finished, .failure = failure};
    }
};

/// Runs a case through core::EditSession. The engine is used by nobody else meanwhile.
[[nodiscard]] StrokeHashes runStroke(core::EditEngine& engine, const StrokeCase& strokeCase);
/// Carries out the edit once. That is all that is needed to compare another engine, in a fifth of
/// the time of runStroke().
[[nodiscard]] StrokeEnds strokeEnds(core::EditEngine& engine, const StrokeCase& strokeCase);

/// What is inconsistent within the hashes, in words; empty if nothing is.
[[nodiscard]] QString contradiction(const StrokeHashes& hashes);
/// Returns what is inconsistent within @p actual, or where it differs from the result of another
/// engine; empty if nothing does.
[[nodiscard]] QString difference(const StrokeEnds& expected, const StrokeHashes& actual);

} // namespace test
