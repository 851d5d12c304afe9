// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <variant>
#include <vector>

namespace test {

// What a session does with an engine, as data: a case runs on any engine, and two outcomes can be
// compared. Growth on plane p goes on from the generation that the case stands at, as a session's
// document would tell it.

/// BeginEdit of a growth whose `generation` is where the plane stands. (A GrowAnew gets it too.)
struct BeginGrowth {
    core::GrowBurst burst;
};
/// A whole edit that takes back the last generations of a plane's growth, or all but the seeds.
struct Shrink {
    core::ShrinkGrowth shrink; ///< `generation` and `keep` are filled in
    std::optional<std::uint32_t> generations{};
    std::vector<std::uint32_t> then{}; ///< generations that it goes to before it ends, modulo
    core::Ending ending = core::Ending::Commit;
};
/// A whole edit that takes back what grew through some places.
struct Cut {
    core::CutGrowth cut; ///< `generation` is filled in
    core::Ending ending = core::Ending::Commit;
};
/// Swap back the last committed edit that is not yet undone; nothing if there is none.
struct Undo { };
/// Swap in again what was undone last; nothing if there is none.
struct Redo { };
/// Wait, and note how the growth stands.
struct Settle { };

using EngineStep = std::variant<core::EngineCommand, BeginGrowth, Shrink, Cut, Undo, Redo, Settle>;

[[nodiscard]] inline EngineStep command(core::EngineCommand known)
{
    return known;
}

struct EngineCase {
    QByteArray name;
    Codes codes;
    std::vector<EngineStep> steps;
};

struct EngineOutcome {
    /// In submission order; the ticket is the command's place in the case, counted from 0.
    std::vector<core::EngineResult> results;
    std::vector<core::GrowthProgress> progress; ///< at every Settle while a growth is open
    std::vector<core::BrickChange> state; ///< all bricks that are not empty, at the end
    QString failure; ///< the engine broke a promise of the seam that needs no comparison
};

[[nodiscard]] EngineOutcome runCase(core::EditEngine& engine, const EngineCase& engineCase);

/// Where two outcomes part, in words; empty if they are equal in all but milliseconds.
[[nodiscard]] QString difference(const EngineOutcome& expected, const EngineOutcome& actual);

/// Waits. @return the result that came last; an empty one if there is none
[[nodiscard]] core::EngineResult lastResult(core::EditEngine& engine);

/// Steps for an edit in one go.
void appendWhole(std::vector<EngineStep>& steps, core::EngineEdit edit,
    std::vector<core::EngineExtension> extensions = {}, core::Ending ending = core::Ending::Commit);

} // namespace test
