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

/// What is drawn besides. Histories without it stay as they were.
struct RandomDraws {
    /// Most edits of labels are given an editable range, counted as "editable".
    bool limited = false;
    /// Masks that overlap are imported, into several label planes; what becomes of segments beyond
    /// the first plane is counted in addition, as "paint, further plane".
    bool planes = false;
    /// More growths, most of which compare medians with their interval, counted as "smoothed".
    bool smoothed = false;
    /// Fillings between named planes of several directions, counted as "between planes".
    bool crossing = false;
};

/// @param engine used by nobody else meanwhile; it may refuse memory while the user acts
/// @param acting called before (true) and after (false) each step; comparisons happen in between,
/// undisturbed
[[nodiscard]] RandomHistory runRandomHistory(core::EditEngine& engine, int commands,
    std::uint32_t seed, const std::function<void(bool)>& acting = {},
    const RandomDraws& draws = {});

} // namespace test
