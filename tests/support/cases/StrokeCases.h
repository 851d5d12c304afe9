// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/engine/EditEngine.h"
#include "core/volume/Volume.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace test {

/// One edit as a user makes it, on what earlier edits left.
struct StrokeCase {
    QByteArray name;
    core::LoadedVolume volume;
    std::vector<core::Edit> before;
    core::Edit edit;
};

/// State hashes of everything that can become of an edit. Six must equal `finished`, two `before`.
struct StrokeHashes {
    QByteArray before;
    QByteArray finished;
    QByteArray inPieces; ///< told as a pen or a running growth tells it
    QByteArray cancelled;
    QByteArray undone;
    QByteArray redone;
    QByteArray again; ///< undone and made anew: a second branch
    QByteArray reopened; ///< from the session file
    QByteArray replayed; ///< from the recorded edits, in a session of its own
    QString failure; ///< something refused that must not be
};

/// Runs a case through core::EditSession. The engine is used by nobody else meanwhile.
[[nodiscard]] StrokeHashes runStroke(core::EditEngine& engine, const StrokeCase& strokeCase);

/// What does not agree in itself, in words; empty if all does.
[[nodiscard]] QString contradiction(const StrokeHashes& hashes);
/// The same between two engines.
[[nodiscard]] QString difference(const StrokeHashes& expected, const StrokeHashes& actual);

[[nodiscard]] std::vector<StrokeCase> strokeCases(int randomCount);

} // namespace test
