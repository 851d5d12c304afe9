// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "core/engine/EngineCommands.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <variant>
#include <vector>

namespace test {

// The commands of a session to an engine as data: a case can be run on any engine, and two outcomes
// can be compared. A growth on plane p continues from the generation that the case has reached, as
// the document of a session would tell it.

/// BeginEdit of a growth whose `generation` is filled in with the plane's present one. (This is
/// also done for a GrowAnew.)
struct BeginGrowth {
    core::GrowBurst burst;
};
/// A complete edit that takes back the last generations of a plane's growth, or all but the seeds.
struct Shrink {
    core::ShrinkGrowth shrink; ///< `generation` and `keep` are filled in
    std::optional<std::uint32_t> generations{};
    /// Generations that it goes to before it ends, taken modulo the number of generations.
    std::vector<std::uint32_t> then{};
    core::Ending ending = core::Ending::Commit;
};
/// A complete edit that takes back what grew through some places.
struct Cut {
    core::CutGrowth cut; ///< `generation` is filled in
    /// Of a cut backwards: steps that it is taken to before it ends.
    std::vector<std::uint32_t> then{};
    core::Ending ending = core::Ending::Commit;
};
/// Takes back the last committed edit that is not yet undone; does nothing if there is none.
struct Undo { };
/// Restores what was undone last; does nothing if there is none.
struct Redo { };
/// Waits, and records the progress of the growth.
struct Settle { };

using EngineStep = std::variant<core::EngineCommand, BeginGrowth, Shrink, Cut, Undo, Redo, Settle>;

[[nodiscard]] inline EngineStep command(core::EngineCommand known)
{
    return known;
}

/// A volume, and the steps to carry out on it.
struct EngineCase {
    QByteArray name;
    Codes codes;
    std::vector<EngineStep> steps;
};

/// Everything that a case observes of an engine.
struct EngineOutcome {
    /// In submission order; the ticket is the index of the command in the case.
    std::vector<core::EngineResult> results;
    /// At every Settle while a growth is open, and while a cut backwards goes on.
    std::vector<core::GrowthProgress> progress;
    std::vector<core::BrickChange> state; ///< all bricks that are not empty, at the end
    QString failure; ///< a violation of the engine's contract that was found without comparison
};

[[nodiscard]] EngineOutcome runCase(core::EditEngine& engine, const EngineCase& engineCase);

/// The first difference between two outcomes, in words; empty if they are equal except for
/// milliseconds.
[[nodiscard]] QString difference(const EngineOutcome& expected, const EngineOutcome& actual);

/// Waits for the engine.
/// @return the last result; an empty one if there is none
[[nodiscard]] core::EngineResult lastResult(core::EditEngine& engine);

/// Appends the steps of a complete edit.
void appendWhole(std::vector<EngineStep>& steps, core::EngineEdit edit,
    std::vector<core::EngineExtension> extensions = {}, core::Ending ending = core::Ending::Commit);

} // namespace test
