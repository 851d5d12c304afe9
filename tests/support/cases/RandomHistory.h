// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <map>
#include <vector>

namespace test {

/// A session that a hasty user works in: every kind of command, undo, redo, jumps to any row of any
/// branch, strokes that are given up, the file closed and opened again; after each step compared
/// with HistoryTruth.
struct RandomHistory {
    QString failure; ///< the first difference, with the step it came at; empty: none
    std::map<QString, int> done; ///< how often what was carried out (by the edit's name)
    std::map<QString, int> refused;
    std::vector<QByteArray> hashes; ///< after each step: the same on every engine
};

/// @param engine used by nobody else meanwhile; it may refuse memory while the user acts
/// @param acting told before (true) and after each step; what is compared between is compared
/// undisturbed
[[nodiscard]] RandomHistory runRandomHistory(core::EditEngine& engine, int commands,
    std::uint32_t seed, const std::function<void(bool)>& acting = {});

} // namespace test
