// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <map>
#include <vector>

namespace test {

/// The result of a random session: every kind of command, undo, redo, jumps to any row of any
/// branch, cancelled strokes, and closing and opening the file; after each step the session is
/// compared with HistoryTruth.
struct RandomHistory {
    QString failure; ///< the first difference, with the step where it was found; empty if none
    /// How often each edit was carried out, by name; of edits with rules, each rule by itself.
    std::map<QString, int> done;
    std::map<QString, int> refused;
    std::vector<QByteArray> hashes; ///< after each step; equal on every engine
};

/// @param engine used by nobody else meanwhile; it may refuse memory while the user acts
/// @param acting called before (true) and after (false) each step; comparisons happen in between,
/// undisturbed
/// @param limited most edits of labels are given an editable range, counted as "editable"; else
/// none is
[[nodiscard]] RandomHistory runRandomHistory(core::EditEngine& engine, int commands,
    std::uint32_t seed, const std::function<void(bool)>& acting = {}, bool limited = false);

} // namespace test
